#include "tests/support/matchers.h"
#include "tests/support/test_data.h"
