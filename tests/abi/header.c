/* The header alone, twice: it needs nothing before it, and does not mind being there already. */
#include <medax.h>
#include <medax.h>

int medax_header_is_c(medax_status status);
int medax_header_is_c(medax_status status) { return status == MEDAX_STATUS_OK; }
