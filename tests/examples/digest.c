/* digest FILE: the 64-bit FNV-1a hash of its bytes, which C, Rust and Python each have in a few lines. */
#include <inttypes.h>
#include <stdio.h>

int main(int argc, char **argv) {
    FILE *file = argc == 2 ? fopen(argv[1], "rb") : NULL;
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    int byte;
    if (file == NULL) return 1;
    while ((byte = getc(file)) != EOF) hash = (hash ^ (uint64_t)byte) * UINT64_C(0x100000001b3);
    printf("%016" PRIx64 "\n", hash);
    return ferror(file) || fclose(file) ? 1 : 0;
}
