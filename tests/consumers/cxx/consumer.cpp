#include <medax.hpp>
int main() { return 0; }
