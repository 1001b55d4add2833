#include "tests/io/dicom/objects/made_objects.h"

#include <dcmtk/config/osconfig.h>
// DCMTK's macros must come first.
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmfg/fgplanpo.h>
#include <dcmtk/dcmpstat/dcmpstat.h>
#include <dcmtk/dcmpstat/dvpstyp.h>
#include <dcmtk/dcmseg/segdoc.h>
#include <dcmtk/dcmseg/segment.h>
#include <dcmtk/dcmsr/dsrdoc.h>
#include <algorithm>

using namespace angiopose;

namespace {

using test::MadeObjects;

/// Reads the objects with DCMTK, whose high-level readers share no code with the writers.
class ObjectsByDcmtk : public MadeObjects {
protected:
    DcmDataset& load(const std::string& name, const core::Result<std::string>& object)
    {
        EXPECT_TRUE(file_.loadFile(written(name, object).c_str()).good());
        return *file_.getDataset();
    }
    static std::string text(DcmItem& item, const DcmTagKey& tag)
    {
        OFString value;
        item.findAndGetOFStringArray(tag, value);
        return value.c_str();
    }

private:
    DcmFileFormat file_;
};

TEST_F(ObjectsByDcmtk, EveryElementHasAValueOfItsKind)
{
    for (const auto& [name, object] : all()) {
        DcmFileFormat file;
        ASSERT_TRUE(file.loadFile(written(name, object).c_str()).good()) << name;
        DcmStack stack;
        while (file.getDataset()->nextObject(stack, OFTrue).good()) {
            auto* element = dynamic_cast<DcmElement*>(stack.top());
            if (element != nullptr && element->isLeaf()) {
                EXPECT_TRUE(element->checkValue("1-n").good() || element->getLength() == 0)
                    << name << ": " << element->getTag().toString().c_str();
            }
        }
    }
}

TEST_F(ObjectsByDcmtk, PixelsOfPicturesAreTheSame)
{
    DcmDataset& data = load("run", io::encodeMultiframeCapture(images(3), angiogram, origin));
    const Uint8* pixels = nullptr;
    unsigned long count = 0;
    ASSERT_TRUE(data.findAndGetUint8Array(DCM_PixelData, pixels, &count).good());
    std::vector<std::uint8_t> expected;
    for (const core::ColorImage& picture : images(3).images) {
        expected.insert(expected.end(), picture.rgb.begin(), picture.rgb.end());
    }
    ASSERT_GE(count, expected.size());
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), pixels));
    EXPECT_EQ(text(data, DCM_ConversionType), "WSD");
    EXPECT_EQ(text(data, DCM_NumberOfFrames), "3");
    EXPECT_EQ(text(data, DCM_PatientName), "Müller^Ünal");
}

TEST_F(ObjectsByDcmtk, PdfIsTheSame)
{
    DcmDataset& data =
        load("report", io::encodeEncapsulatedPdf("%PDF-1.4\nodd", "T", io::BurnedInIdentity::None, angiogram, origin));
    const Uint8* bytes = nullptr;
    unsigned long count = 0;
    ASSERT_TRUE(data.findAndGetUint8Array(DCM_EncapsulatedDocument, bytes, &count).good());
    EXPECT_EQ(std::string(reinterpret_cast<const char*>(bytes), 12), "%PDF-1.4\nodd");
    EXPECT_EQ(text(data, DCM_MIMETypeOfEncapsulatedDocument), "application/pdf");
}

TEST_F(ObjectsByDcmtk, SegmentationHasTheVoxelsAndItsSegment)
{
    DcmDataset& data = load("segmentation", io::encodeVesselSegmentation(vessels(), "drawn", scan, origin));
    DcmSegmentation* found = nullptr;
    ASSERT_TRUE(DcmSegmentation::loadDataset(data, found).good());
    const std::unique_ptr<DcmSegmentation> segmentation(found);
    ASSERT_EQ(segmentation->getNumberOfSegments(), 1U);
    OFString meaning;
    segmentation->getSegment(1)->getSegmentedPropertyTypeCode().getCodeMeaning(meaning);
    EXPECT_STREQ(meaning.c_str(), "Artery");
    ASSERT_EQ(segmentation->getNumberOfFrames(), 5U);
    const core::VoxelMask mask = vessels();
    for (int k = 0; k < 5; ++k) {
        const DcmIODTypes::Frame* frame = segmentation->getFrame(static_cast<size_t>(k));
        ASSERT_NE(frame, nullptr);
        for (std::size_t i = 0; i < 72; ++i) {
            const bool isSet = (frame->pixData[i / 8] >> (i % 8) & 1) != 0;
            EXPECT_EQ(isSet, mask.voxels[static_cast<std::size_t>(k) * 72 + i] != 0) << k << " " << i;
        }
        FGPlanePosPatient* place = OFstatic_cast(
            FGPlanePosPatient*,
            segmentation->getFunctionalGroups().get(static_cast<Uint32>(k), DcmFGTypes::EFG_PLANEPOSPATIENT));
        ASSERT_NE(place, nullptr);
        Float64 x = 0.0, y = 0.0, z = 0.0;
        place->getImagePositionPatient(x, y, z);
        EXPECT_NEAR(z, 100.0 + 1.25 * k, 1e-9);
        EXPECT_NEAR(x, -3.125, 1e-9);
        EXPECT_NEAR(y, 7.75, 1e-9);
    }
}

TEST_F(ObjectsByDcmtk, StateHasLayersLinesAndWindow)
{
    DcmDataset& data = load("state", io::encodePresentationState(shownState(), angiogram, origin));
    DcmPresentationState state;
    ASSERT_TRUE(state.read(data).good());
    ASSERT_EQ(state.getNumberOfGraphicLayers(), 2U);
    EXPECT_STREQ(state.getGraphicLayerName(0), "VESSELS");
    EXPECT_EQ(state.numberOfImageReferences(), 1U);
    DcmItem* annotation = nullptr;
    ASSERT_TRUE(data.findAndGetSequenceItem(DCM_GraphicAnnotationSequence, annotation, 0).good());
    DcmItem* line = nullptr;
    ASSERT_TRUE(annotation->findAndGetSequenceItem(DCM_GraphicObjectSequence, line, 0).good());
    EXPECT_EQ(text(*line, DCM_GraphicType), "POLYLINE");
    const Float32* points = nullptr;
    unsigned long count = 0;
    ASSERT_TRUE(line->findAndGetFloat32Array(DCM_GraphicData, points, &count).good());
    EXPECT_EQ(std::vector<float>(points, points + count), (std::vector<float>{0.5F, 0.5F, 3.75F, 8.0F, 19.5F, 15.5F}));
}

TEST_F(ObjectsByDcmtk, RegistrationKeepsTheCameraToTheLastBit)
{
    DcmDataset& data = load("registration", io::encodeSpatialRegistration(registration(), angiogram, origin));
    EXPECT_EQ(text(data, DcmTagKey(0x0071, 0x0010)), "ANGIOPOSE CAMERA 1");
    for (unsigned long i = 0; i < 16; ++i) {
        Float64 value = NAN;
        ASSERT_TRUE(data.findAndGetFloat64(DcmTagKey(0x0071, 0x1001), value, i).good());
        EXPECT_EQ(value, pose().matrix()(static_cast<int>(i / 4), static_cast<int>(i % 4)));
    }
    Float64 fx = 0.0;
    EXPECT_TRUE(data.findAndGetFloat64(DcmTagKey(0x0071, 0x1002), fx, 0).good());
    EXPECT_EQ(fx, -3500.25);
}

TEST_F(ObjectsByDcmtk, MeasurementsAreAReport)
{
    DcmDataset& data = load("measurements", io::encodeMeasurementReport(measured(), angiogram, origin));
    DSRDocument report;
    ASSERT_TRUE(report.read(data).good());
    EXPECT_EQ(report.getDocumentType(), DSRTypes::DT_Comprehensive3DSR);
    EXPECT_TRUE(report.getTree().isValid());
    OFString mapping, id;
    DSRDocumentTree& tree = report.getTree();
    tree.gotoRoot();
    tree.getCurrentContentItem().getTemplateIdentification(id, mapping);
    EXPECT_STREQ(id.c_str(), "1500");
    ASSERT_NE(tree.gotoNamedNode(DSRCodedEntryValue("410668003", "SCT", "Length")), 0U);
    const DSRNumericMeasurementValue& length = tree.getCurrentContentItem().getNumericValue();
    EXPECT_EQ(std::stod(length.getNumericValue().c_str()), 12.3456789012346);
    EXPECT_STREQ(length.getMeasurementUnit().getCodeValue().c_str(), "mm");
    ASSERT_NE(tree.goDown(), 0U);
    EXPECT_EQ(tree.getCurrentContentItem().getValueType(), DSRTypes::VT_SCoord);
    ASSERT_NE(tree.goDown(), 0U);
    EXPECT_EQ(tree.getCurrentContentItem().getImageReference().getSOPInstanceUID(), angiogram.sopInstanceUid.c_str());
}

}   // namespace
