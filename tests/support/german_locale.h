#pragma once

#include "tests/support/temporary_folder.h"

#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <locale>
#include <string>

namespace angiopose::test {

/// Sets a locale with a decimal comma during its lifetime: the installed one, or one built for the test.
class GermanLocale {
public:
    GermanLocale() { isSet_ = isTaken() || (isMade() && isTaken()); }
    GermanLocale(const GermanLocale&) = delete;
    GermanLocale& operator=(const GermanLocale&) = delete;
    ~GermanLocale()
    {
        std::locale::global(std::locale::classic());
        std::setlocale(LC_ALL, "C");
        ::unsetenv("LOCPATH");
    }

    bool isSet() const { return isSet_ && *std::localeconv()->decimal_point == ','; }

private:
    static constexpr const char* name = "de_DE.UTF-8";

    bool isMade() const
    {
        std::filesystem::create_directory(folder_.file("locale"));
        const std::string command = "localedef -i de_DE -f UTF-8 " + folder_.file("locale") + "/" + name;
        return std::system((command + " > /dev/null 2>&1").c_str()) == 0 &&
               ::setenv("LOCPATH", folder_.file("locale").c_str(), 1) == 0;
    }
    /// Sets the locale for C and for C++.
    static bool isTaken()
    {
        if (!std::setlocale(LC_ALL, name)) {
            return false;
        }
        std::locale::global(std::locale(name));
        return true;
    }

    TemporaryFolder folder_;
    bool isSet_ = false;
};

}   // namespace angiopose::test
