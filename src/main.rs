//! The command line: each subcommand is one file in `cli/`.

mod cli;

fn main() -> std::process::ExitCode {
    cli::main()
}
