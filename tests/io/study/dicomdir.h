#pragma once

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcddirif.h>

#include <gtest/gtest.h>
#include <filesystem>
#include <string>
#include <vector>

namespace angiopose::test {

/// Writes the DICOMDIR of a disc with DCMTK: files below `root`, with names as on such discs ("PAT1/IM1").
inline void writeDicomdir(const std::string& root, const std::vector<std::string>& names)
{
    DicomDirInterface directory;
    directory.disableConsistencyCheck();
    directory.enableInventMode();
    directory.enableMapFilenamesMode();
    const std::string path = (std::filesystem::path(root) / "DICOMDIR").string();
    ASSERT_TRUE(directory.createNewDicomDir(DicomDirInterface::AP_GeneralPurpose, OFFilename(path.c_str())).good());
    for (const std::string& name : names) {
        const OFCondition added = directory.addDicomFile(OFFilename(name.c_str()), OFFilename(root.c_str()));
        ASSERT_TRUE(added.good()) << name << ": " << added.text();
    }
    ASSERT_TRUE(directory.writeDicomDir().good());
}

}   // namespace angiopose::test
