//! The program: the command line of the library.

fn main() -> std::process::ExitCode {
    flockproof::command_line(std::env::args_os()).into()
}
