//! `gamow completions`: how a shell completes the command line.

use clap::{Args, Command};
use clap_complete::Shell;

use crate::files::whole::OutArgs;

/// Writes the completions of the command line for a shell.
#[derive(Debug, Args)]
#[command(before_long_help = EXAMPLES)]
pub struct CompletionsArgs {
    /// Shell that completes.
    #[arg(value_enum)]
    shell: Shell,
    #[command(flatten)]
    out: OutArgs,
}

const EXAMPLES: &str = "\
Examples:
  gamow completions bash --out ~/.local/share/bash-completion/completions/gamow
  gamow completions zsh --out ~/.zfunc/_gamow   (in .zshrc: fpath+=~/.zfunc; autoload -Uz compinit && compinit)
  gamow completions fish --out ~/.config/fish/completions/gamow.fish";

/// Runs the command `gamow completions` for the whole `program`.
pub fn run(args: &CompletionsArgs, mut program: Command) -> anyhow::Result<()> {
    let mut text = Vec::new();
    clap_complete::generate(args.shell, &mut program, "gamow", &mut text);
    args.out.write(|out| Ok(out.write_all(&text)?))
}
