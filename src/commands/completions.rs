//! `gamow completions`: how a shell completes the command line.

use clap::{Args, Command, ValueEnum};
use clap_complete::Shell;

use crate::files::whole::OutArgs;

/// Writes the completions of the command line for a shell.
#[derive(Debug, Args)]
#[command(before_long_help = EXAMPLES)]
pub struct CompletionsArgs {
    /// Shell that completes.
    #[arg(value_enum)]
    shell: ShellChoice,
    #[command(flatten)]
    out: OutArgs,
}

/// A shell that can complete.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum ShellChoice {
    Bash,
    Elvish,
    Fish,
    Powershell,
    Zsh,
}

const EXAMPLES: &str = "\
Examples:
  gamow completions bash --out ~/.local/share/bash-completion/completions/gamow
  gamow completions zsh --out ~/.zfunc/_gamow   (in .zshrc: fpath+=~/.zfunc; autoload -Uz compinit && compinit)
  gamow completions fish --out ~/.config/fish/completions/gamow.fish";

/// Runs the command `gamow completions` for the whole `program`.
pub fn run(args: &CompletionsArgs, mut program: Command) -> anyhow::Result<()> {
    let shell = match args.shell {
        ShellChoice::Bash => Shell::Bash,
        ShellChoice::Elvish => Shell::Elvish,
        ShellChoice::Fish => Shell::Fish,
        ShellChoice::Powershell => Shell::PowerShell,
        ShellChoice::Zsh => Shell::Zsh,
    };
    let mut text = Vec::new();
    clap_complete::generate(shell, &mut program, "gamow", &mut text);
    args.out.write(|out| Ok(out.write_all(&text)?))
}
