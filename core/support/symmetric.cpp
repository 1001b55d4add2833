#include "core/support/symmetric.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace angiopose::core {
namespace {

template <int Size>
Axes<Size> solvedAxes(const Eigen::Matrix<double, Size, Size>& matrix)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, Size, Size>> solver(matrix);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

}   // namespace

Axes<2> axesOf(const Eigen::Matrix<double, 2, 2>& matrix)
{
    return solvedAxes<2>(matrix);
}

Axes<3> axesOf(const Eigen::Matrix<double, 3, 3>& matrix)
{
    return solvedAxes<3>(matrix);
}

Axes<6> axesOf(const Eigen::Matrix<double, 6, 6>& matrix)
{
    return solvedAxes<6>(matrix);
}

UpToSix inverseOf(const UpToSix& matrix)
{
    return matrix.inverse();
}

Eigen::Matrix<double, 6, 6> inverseOf(const Eigen::Matrix<double, 6, 6>& matrix)
{
    return matrix.inverse();
}

Eigen::Vector<double, 6> solveSymmetric(const Eigen::Matrix<double, 6, 6>& A, const Eigen::Vector<double, 6>& b)
{
    return A.ldlt().solve(b);
}

Eigen::MatrixXd solveSymmetric(const Eigen::MatrixXd& A, const Eigen::MatrixXd& b)
{
    return A.ldlt().solve(b);
}

}   // namespace angiopose::core
