#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// How the numbers of a file are written.
enum class Coding { Text, LittleEndian, BigEndian };

/// A number as binary files hold it.
struct NumberType {
    std::string_view names;   ///< each between blanks
    std::size_t size;
    double (*read)(const char* bytes, bool isTurned);
};

/// By the names of PLY and VTK ("uchar", "float32", "unsigned_int", …), in any case; null for others.
const NumberType* numberTypeOf(std::string_view name);

/// Walks through the words and numbers of a file. Nothing is allocated for values that the rest of it cannot hold.
class ValueCursor {
public:
    explicit ValueCursor(std::string_view content, Coding coding = Coding::Text) : rest_(content), coding_(coding) {}

    void setCoding(Coding coding) { coding_ = coding; }
    bool isText() const { return coding_ == Coding::Text; }
    bool isAtEnd() const;
    std::size_t left() const { return rest_.size(); }   ///< bytes

    std::string_view bytes(std::size_t count);   ///< the next ones; fewer at the end
    std::string_view line();   ///< up to the next line end, trimmed
    std::string_view word();   ///< between blanks; empty at the end
    std::string_view peekWord() const { return ValueCursor(*this).word(); }
    std::optional<std::size_t> count();   ///< the next word as a whole number from 0
    std::optional<Eigen::Vector3d> point();   ///< the next three words

    std::optional<double> number(const NumberType& type);   ///< a word in text, whatever the type
    /// Nothing when they are not all there, or of no known type in a binary file.
    std::optional<std::vector<double>> numbers(std::size_t count, const NumberType* type);

private:
    std::string_view rest_;
    Coding coding_;
};

}   // namespace angiopose::io
