#pragma once

#include <cstddef>
#include <string>

namespace angiopose::test {

/// Receives objects on its own port into a store in `folder` and keeps sending some there, until it is killed.
int receiveForEver(const std::string& folder, int ready);

/// Names the received objects that are incomplete; empty if all are complete.
std::string findHalfReceived(const std::string& folder);

/// Number of objects that were being received when the program was killed.
std::size_t interruptedIn(const std::string& folder);

/// Starts receiving there, as the next program would. Deletes the objects received so far, so that the next kill starts
/// with an empty store.
void receiveAgain(const std::string& folder);

}   // namespace angiopose::test
