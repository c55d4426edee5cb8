package enlightenment.cli.input;

import enlightenment.cli.option.BadValue;
import enlightenment.cli.option.FilePath;
import enlightenment.cli.option.Typos;
import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.ExitCode;
import enlightenment.cli.terminal.Terminal;
import enlightenment.file.FileFailure;
import enlightenment.scene.SceneException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import picocli.CommandLine;
import picocli.CommandLine.IExecutionExceptionHandler;
import picocli.CommandLine.IParameterExceptionHandler;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.UnmatchedArgumentException;

/** Turns exceptions into messages and an exit code. It is the only place that does so; commands only throw. */
public final class Failures implements IParameterExceptionHandler, IExecutionExceptionHandler {
    private final Terminal terminal;

    public Failures(Terminal terminal) {
        this.terminal = terminal;
    }

    @Override
    public int handleParseException(ParameterException e, String[] args) {
        return report(e);
    }

    @Override
    public int handleExecutionException(Exception e, CommandLine command, ParseResult parsed) {
        return report(e);
    }

    /** Prints a failure and returns the exit code. */
    public int report(Throwable t) {
        if (Boolean.getBoolean("enlightenment.trace")) {
            t.printStackTrace(terminal.err());
        }
        if (t instanceof ParameterException e) {
            wrongUsage(e);
            return ExitCode.WRONG_INPUT;
        }
        if (t instanceof CliException e) {
            terminal.say(e.getMessage());
            return e.exitCode();
        }
        if (t instanceof SceneException e) {
            SceneFailures.tell(e, terminal);
            return ExitCode.WRONG_INPUT;
        }
        if (t instanceof CancellationException e) {
            terminal.say(e.getMessage());
        } else if (ioFailure(t).isPresent()) {
            terminal.say(FileFailure.described(ioFailure(t).get()));
        } else if (t instanceof OutOfMemoryError) {
            terminal.say("out of memory; java -Xmx sets how much there is");
        } else {
            terminal.say("internal error: " + t + " (java -Denlightenment.trace=true shows where)");
        }
        return ExitCode.FAILED;
    }

    /**
     * The failure of reading or writing behind what was thrown; empty if something else went wrong. Where a process may open no more files,
     * Java cannot load its own classes, and wraps that in errors of linking.
     */
    private static Optional<IOException> ioFailure(Throwable thrown) {
        Throwable t = thrown;
        while (t instanceof UncheckedIOException || t instanceof LinkageError) {
            t = t.getCause();
        }
        return t instanceof IOException e ? Optional.of(e) : Optional.empty();
    }

    private void wrongUsage(ParameterException e) {
        if (e.getCause() instanceof BadValue value && e.getArgSpec() != null) {
            terminal.say(name(e.getArgSpec()) + " " + value.getMessage());
            return;
        }
        Optional<String> unusable = unusableName(e);
        if (unusable.isPresent()) {
            terminal.say(unusable.get());
            return;
        }
        List<String> typos = Typos.unknownOptions(e);
        if (typos.isEmpty()) {
            terminal.say(firstLetterSmall(e.getMessage()));
        }
        typos.forEach(terminal::say);
        String topic = e.getCommandLine().getCommandSpec().qualifiedName().replaceFirst("^enlightenment ?", "");
        terminal.say("see 'enlightenment help" + (topic.isEmpty() ? "" : " " + topic) + "'");
    }

    /** A list of files ends for picocli before a name that cannot be used, which then belongs to nothing. */
    private static Optional<String> unusableName(ParameterException e) {
        if (!(e instanceof UnmatchedArgumentException unmatched)) {
            return Optional.empty();
        }
        for (ArgSpec files : e.getCommandLine().getCommandSpec().positionalParameters()) {
            for (String word : files.isMultiValue() ? unmatched.getUnmatched() : List.<String>of()) {
                try {
                    new FilePath().convert(word);
                } catch (BadValue value) {
                    return Optional.of(name(files) + " " + value.getMessage());
                }
            }
        }
        return Optional.empty();
    }

    private static String name(ArgSpec arg) {
        return arg instanceof OptionSpec option ? option.longestName() : arg.paramLabel();
    }

    private static String firstLetterSmall(String message) {
        return message.isEmpty() ? message : Character.toLowerCase(message.charAt(0)) + message.substring(1);
    }
}
