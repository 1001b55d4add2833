#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

// Protocol of a helper program's standard output: the progress as single bytes (percent), then one byte for the kind of
// reply, the length of the content, and the content. Both programs run on the same machine, so numbers are in native
// byte order.

namespace angiopose::io {

constexpr unsigned char maxPercent = 100;

/// Kind of the content that follows the progress.
enum class ReplyKind : unsigned char {
    Result = 201,
    Refusal = 202,   ///< the library found the file damaged; the content gives the position, if known
    TooLarge = 203,   ///< the library needed more memory than permitted
};

struct DecoderReply {
    ReplyKind kind = ReplyKind::Refusal;
    std::string content;
};

/// Serializes values to bytes: numbers, arrays of numbers, strings, and vectors and maps of these.
class ReplyWriter {
public:
    template <class Value>
    requires std::is_arithmetic_v<Value>
    void put(const Value& value) { bytes_.append(reinterpret_cast<const char*>(&value), sizeof value); }

    template <class Value, std::size_t Count>
    void put(const std::array<Value, Count>& values)
    {
        putAll(values);
    }
    void put(const Eigen::Vector3d& point) { putAll(point); }

    void put(const std::string& text)
    {
        put(std::uint64_t{text.size()});
        bytes_ += text;
    }
    template <class Value>
    void put(const std::vector<Value>& values)
    {
        put(std::uint64_t{values.size()});
        putAll(values);
    }
    template <class Value>
    void put(const std::map<std::string, Value>& values)
    {
        put(std::uint64_t{values.size()});
        for (const auto& [name, value] : values) {
            put(name);
            put(value);
        }
    }

    std::string bytes() && { return std::move(bytes_); }

private:
    template <class Values>
    void putAll(const Values& values)
    {
        for (const auto& value : values) {
            put(value);
        }
    }

    std::string bytes_;
};

/// Deserializes the values written by ReplyWriter. Never allocates more memory than the remaining bytes can fill. After
/// a missing value, all later values are missing as well.
class ReplyReader {
public:
    explicit ReplyReader(std::string_view bytes) : remaining_(bytes) {}

    template <class Value>
    requires std::is_arithmetic_v<Value>
    void take(Value& value)
    {
        if (has(sizeof value)) {
            std::memcpy(&value, remaining_.data(), sizeof value);
            remaining_.remove_prefix(sizeof value);
        }
    }
    template <class Value, std::size_t Count>
    void take(std::array<Value, Count>& values)
    {
        takeAll(values);
    }
    void take(Eigen::Vector3d& point) { takeAll(point); }

    void take(std::string& text)
    {
        text = remaining_.substr(0, takeCount(1));
        remaining_.remove_prefix(text.size());
    }
    template <class Value>
    void take(std::vector<Value>& values)
    {
        values.resize(takeCount(std::is_arithmetic_v<Value> ? sizeof(Value) : 8));
        takeAll(values);
    }
    template <class Value>
    void take(std::map<std::string, Value>& values)
    {
        for (std::size_t left = takeCount(16); left > 0 && isValid_; --left) {
            std::string name;
            take(name);
            take(values[name]);
        }
    }

    /// Returns whether all values were present and no bytes are left over.
    bool isDone() const { return isValid_ && remaining_.empty(); }

private:
    bool has(std::size_t size)
    {
        isValid_ = isValid_ && size <= remaining_.size();
        return isValid_;
    }
    /// Reads and returns an element count; each element takes at least `size` bytes.
    std::size_t takeCount(std::size_t size)
    {
        std::uint64_t count = 0;
        take(count);
        isValid_ = isValid_ && count <= remaining_.size() / size;
        return isValid_ ? static_cast<std::size_t>(count) : 0;
    }
    template <class Values>
    void takeAll(Values& values)
    {
        for (auto& value : values) {
            take(value);
        }
    }

    std::string_view remaining_;
    bool isValid_ = true;
};

}   // namespace angiopose::io
