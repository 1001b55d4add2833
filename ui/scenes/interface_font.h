#pragma once

#include <string>

namespace ui {

/// Font file for text in pictures: Inter where it is installed, else the system's sans serif; empty when none is found.
const std::string& interfaceFontFile();

}   // namespace ui
