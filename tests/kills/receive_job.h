#pragma once

#include <cstddef>
#include <string>

namespace angiopose::test {

/// Takes objects at a port of its own into a store in `folder`, and sends some there all the time, until it is killed.
int receiveForEver(const std::string& folder, int ready);

/// What of the objects that came is not whole; empty: everything is.
std::string findHalfReceived(const std::string& folder);

/// Objects that were coming when the program was killed.
std::size_t interruptedIn(const std::string& folder);

/// As the next program does that receives there. What came before is taken away, so that the next kill counts anew.
void receiveAgain(const std::string& folder);

}   // namespace angiopose::test
