#include "io/support/library_versions.h"

#include <curl/curlver.h>
#include <dcmtk/config/osconfig.h>
#include <itkVersion.h>
#include <vtkVersionMacros.h>
#include <Eigen/Core>
#include <opencv2/core/version.hpp>

namespace angiopose::io {

std::string buildInfo()
{
#ifdef NDEBUG
    const std::string kind = "without assertions";
#else
    const std::string kind = "with assertions";
#endif
    const auto three = [](int major, int minor, int patch) {
        return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
    };
    return std::string("AngioPose: ") + ANGIOPOSE_VERSION + "\nbuild: " + kind + "\ncompiler: " + ANGIOPOSE_COMPILER +
           "\nVTK: " + VTK_VERSION + "\nITK: " + itk::Version::GetITKVersion() + "\nOpenCV: " + CV_VERSION +
           "\nDCMTK: " + PACKAGE_VERSION + "\nlibcurl: " + LIBCURL_VERSION +
           "\nEigen: " + three(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION) + "\n";
}

}   // namespace angiopose::io
