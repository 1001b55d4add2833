#pragma once

#include <Eigen/Core>

namespace angiopose::core {

/// Eigen's decompositions of small symmetric matrices, compiled only once because each adds seconds to the build of
/// every source that uses it. Both triangles of the matrices must be filled.
template <int Size>
struct EigenDecomposition {
    Eigen::Vector<double, Size> values;   ///< eigenvalues, ascending
    Eigen::Matrix<double, Size, Size> directions;   ///< one unit eigenvector per column, in the order of `values`
};

EigenDecomposition<2> eigenDecomposition(const Eigen::Matrix<double, 2, 2>& matrix);
EigenDecomposition<3> eigenDecomposition(const Eigen::Matrix<double, 3, 3>& matrix);
EigenDecomposition<6> eigenDecomposition(const Eigen::Matrix<double, 6, 6>& matrix);

/// Matrix with at most six rows and columns, stored on the stack.
using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;

/// Returns the inverse of a regular matrix, symmetric or not, by LU decomposition.
SmallMatrix inverseOf(const SmallMatrix& matrix);
Eigen::Matrix<double, 6, 6> inverseOf(const Eigen::Matrix<double, 6, 6>& matrix);

/// Solves A x = b by LDLᵀ; the result is finite even if A is singular.
Eigen::Vector<double, 6> solveSymmetric(const Eigen::Matrix<double, 6, 6>& A, const Eigen::Vector<double, 6>& b);
Eigen::MatrixXd solveSymmetric(const Eigen::MatrixXd& A, const Eigen::MatrixXd& b);

}   // namespace angiopose::core
