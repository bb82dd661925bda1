#include "cli/app.hpp"

int main(int argc, char** argv) { return warpgrain::cli::run_app(argc, argv); }
