#include "core/support/symmetric.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace angiopose::core {
namespace {

template <int Size>
EigenDecomposition<Size> solveEigen(const Eigen::Matrix<double, Size, Size>& matrix)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, Size, Size>> solver(matrix);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

}   // namespace

EigenDecomposition<2> eigenDecomposition(const Eigen::Matrix<double, 2, 2>& matrix)
{
    return solveEigen<2>(matrix);
}

EigenDecomposition<3> eigenDecomposition(const Eigen::Matrix<double, 3, 3>& matrix)
{
    return solveEigen<3>(matrix);
}

EigenDecomposition<6> eigenDecomposition(const Eigen::Matrix<double, 6, 6>& matrix)
{
    return solveEigen<6>(matrix);
}

SmallMatrix inverseOf(const SmallMatrix& matrix)
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
