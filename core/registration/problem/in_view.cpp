#include "core/registration/problem/in_view.h"

#include "core/messages/messages.h"

namespace angiopose::core {

Error inView(std::size_t number, const Error& error)
{
    return error.isCancellation() ? error : Error(messages::inView(number, error.message));
}

}   // namespace angiopose::core
