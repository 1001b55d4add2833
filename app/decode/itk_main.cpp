#include "app/decode/helper_session.h"

#include <itkAffineTransform.h>
#include <itkCompositeTransform.h>
#include <itkHDF5TransformIO.h>
#include <itkTransformFactoryBase.h>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

// angiopose-decode-itk read FILE replies with the transform of an ITK HDF5 file as three rows of four numbers. It
// refuses files that do not contain exactly one transform (empty reply) and nonlinear transforms (the reply is the
// type). angiopose-decode-itk write N… replies with an ITK HDF5 file made from twelve numbers.

namespace {

using angiopose::io::DecoderReply;
using angiopose::io::ReplyKind;
using TransformIo = itk::HDF5TransformIOTemplate<double>;
using Transform = itk::Transform<double, 3, 3>;
using Rows = std::array<double, 12>;   // pose in row-major order

/// Temporary file in a folder that only the user can access, removed with this object.
class TemporaryFile {
public:
    TemporaryFile()
    {
        std::random_device chance;
        do {
            folder_ = std::filesystem::temp_directory_path() / ("angiopose-" + std::to_string(chance()));
        } while (!std::filesystem::create_directory(folder_));
        std::filesystem::permissions(folder_, std::filesystem::perms::owner_all);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile()
    {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    std::string path() const
    {
        return (folder_ / "transform.h5").string();
    }   // needed because ITK selects the format by the extension

private:
    std::filesystem::path folder_;
};

/// Returns the only transform of the file: a single one, or the composite whose components follow it in the list.
Transform::Pointer singleTransform(const TransformIo::TransformListType& list)
{
    Transform::Pointer first = list.empty() ? nullptr : dynamic_cast<Transform*>(list.front().GetPointer());
    auto* composite = dynamic_cast<itk::CompositeTransform<double, 3>*>(first.GetPointer());
    if (!composite) {
        return list.size() == 1 ? first : nullptr;
    }
    for (auto part = std::next(list.begin()); part != list.end(); ++part) {
        auto* transform = dynamic_cast<Transform*>(part->GetPointer());
        if (!transform) {
            return nullptr;
        }
        composite->AddTransform(transform);
    }
    return composite->IsTransformQueueEmpty() ? nullptr : first;
}

Rows rowsOf(const Transform& transform)
{
    const Transform::InputPointType origin{};
    const Transform::OutputPointType offset = transform.TransformPoint(origin);
    Transform::JacobianPositionType matrix;
    transform.ComputeJacobianWithRespectToPosition(origin, matrix);
    Rows rows;
    for (unsigned int row = 0; row < 3; ++row) {
        for (unsigned int column = 0; column < 3; ++column) {
            rows[4 * row + column] = matrix(row, column);
        }
        rows[4 * row + 3] = offset[row];
    }
    return rows;
}

DecoderReply read(const std::string& path)
{
    const TransformIo::Pointer reader = TransformIo::New();
    reader->SetFileName(path);
    reader->Read();
    const Transform::Pointer transform = singleTransform(reader->GetReadTransformList());
    if (!transform || !transform->IsLinear()) {
        return {ReplyKind::Refusal, transform ? transform->GetTransformTypeAsString() : std::string()};
    }
    angiopose::io::ReplyWriter reply;
    reply.put(rowsOf(*transform));
    return {ReplyKind::Result, std::move(reply).bytes()};
}

DecoderReply write(const Rows& rows)
{
    using Affine = itk::AffineTransform<double, 3>;
    const Affine::Pointer transform = Affine::New();
    Affine::ParametersType parameters(12);   // matrix in row-major order, then the translation
    for (unsigned int row = 0; row < 3; ++row) {
        for (unsigned int column = 0; column < 3; ++column) {
            parameters[3 * row + column] = rows[4 * row + column];
        }
        parameters[9 + row] = rows[4 * row + 3];
    }
    transform->SetParameters(parameters);
    const TemporaryFile file;
    const TransformIo::Pointer writer = TransformIo::New();
    writer->SetFileName(file.path());
    TransformIo::ConstTransformListType list{transform.GetPointer()};
    writer->SetTransformList(list);
    writer->Write();
    std::ifstream stream(file.path(), std::ios::binary);
    return {ReplyKind::Result, {std::istreambuf_iterator<char>(stream), {}}};
}

}   // namespace

int main(int count, char** arguments)
{
    const std::string task = count > 1 ? arguments[1] : "";
    if (task == "read" && count == 3) {
        const std::string path = arguments[2];
        std::error_code ignored;
        angiopose::decode::limitProcess(std::filesystem::file_size(path, ignored));
        return angiopose::decode::writeReply([&path] { return read(path); });
    }
    Rows rows;
    if (task != "write" || count != 2 + static_cast<int>(rows.size())) {
        return 2;
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i] = std::strtod(arguments[2 + i], nullptr);
    }
    return angiopose::decode::writeReply([&rows] { return write(rows); });
}
