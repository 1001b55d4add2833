#include "resources/translations/collect/cpp_tokens.h"

#include <algorithm>
#include <cctype>

namespace core_texts {
namespace {

bool isNamePart(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

class Reader {
public:
    explicit Reader(std::string_view source) : rest_(source) {}

    /// Tokens up to the closing bracket or the end.
    std::vector<Token> readGroup()
    {
        std::vector<Token> tokens;
        while (!rest_.empty()) {
            const char c = rest_.front();
            if (c == ')' || c == ']' || c == '}') {
                drop(1);
                break;
            }
            if (!skipSilent()) {
                tokens.push_back(readToken());
            }
        }
        return tokens;
    }

private:
    void drop(std::size_t count) { rest_.remove_prefix(std::min(count, rest_.size())); }

    void dropUntil(std::string_view end)
    {
        const auto place = rest_.find(end);
        drop(place == std::string_view::npos ? rest_.size() : place + end.size());
    }

    /// White space and whatever says nothing.
    bool skipSilent()
    {
        const char c = rest_.front();
        if (std::isspace(static_cast<unsigned char>(c)) != 0) {
            drop(1);
        } else if (rest_.starts_with("//") || c == '#') {
            dropUntil("\n");
        } else if (rest_.starts_with("/*")) {
            dropUntil("*/");
        } else if (c == '\'') {
            drop(rest_.size() > 1 && rest_[1] == '\\' ? 3 : 2);
            dropUntil("'");
        } else {
            return false;
        }
        return true;
    }

    Token readToken()
    {
        const char c = rest_.front();
        if (rest_.starts_with("R\"(")) {
            dropUntil(")\"");
            return {Token::Kind::Name, "raw"};
        }
        if (c == '"') {
            return {Token::Kind::Literal, readLiteral()};
        }
        if (isNamePart(c)) {
            return {Token::Kind::Name, readName()};
        }
        if (rest_.starts_with("::") || rest_.starts_with("->")) {
            drop(2);
            return {Token::Kind::Name, "::"};
        }
        drop(1);
        if (c == '(' || c == '[' || c == '{') {
            return {Token::Kind::Group, std::string(1, c), readGroup()};
        }
        return {Token::Kind::Mark, std::string(1, c)};
    }

    std::string readLiteral()
    {
        std::string value;
        drop(1);
        while (!rest_.empty() && rest_.front() != '"') {
            if (rest_.front() == '\\') {
                drop(1);
                value += rest_.front() == 'n' ? '\n' : rest_.front();
            } else {
                value += rest_.front();
            }
            drop(1);
        }
        drop(1);
        return value;
    }

    /// Also numbers, with the marks that part their digits.
    std::string readName()
    {
        std::size_t length = 0;
        while (length < rest_.size() &&
               (isNamePart(rest_[length]) ||
                (rest_[length] == '\'' && std::isdigit(static_cast<unsigned char>(rest_.front())) != 0))) {
            ++length;
        }
        std::string name(rest_.substr(0, length));
        drop(length);
        return name;
    }

    std::string_view rest_;
};

}   // namespace

std::vector<Token> tokensOf(std::string_view source)
{
    return Reader(source).readGroup();
}

}   // namespace core_texts
