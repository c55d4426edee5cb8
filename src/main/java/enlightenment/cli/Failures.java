package enlightenment.cli;

import enlightenment.math.InvalidValueException;
import enlightenment.scene.SceneException;
import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.util.ArrayList;
import java.util.List;
import picocli.CommandLine;

/** Turns what went wrong into messages and an exit code. */
final class Failures {
    private final Terminal terminal;

    Failures(Terminal terminal) {
        this.terminal = terminal;
    }

    /** Says what went wrong; gives the exit code. */
    int report(Throwable thrown) {
        if (Boolean.getBoolean("enlightenment.trace")) {
            thrown.printStackTrace(terminal.err());
        }
        Throwable t =
                thrown instanceof CommandLine.ExecutionException e && e.getCause() != null ? e.getCause() : thrown;
        if (t instanceof CommandLine.ParameterException e) {
            return wrongUsage(e);
        }
        if (t instanceof CliException e) {
            terminal.say(e.getMessage());
            return e.exitCode();
        }
        if (t instanceof SceneException e) {
            problems(e);
            return CliException.WRONG_INPUT;
        }
        if (t instanceof IOException e) {
            terminal.say(describe(e));
            return CliException.FAILED;
        }
        if (t instanceof OutOfMemoryError) {
            terminal.say("out of memory; java -Xmx sets how much there is");
            return CliException.FAILED;
        }
        terminal.say("internal error: " + t + " (java -Denlightenment.trace=true shows where)");
        return CliException.FAILED;
    }

    private int wrongUsage(CommandLine.ParameterException e) {
        String command = e.getCommandLine().getCommandName();
        String topic = command.replaceFirst("^enlightenment ?", "");
        List<String> typos = Typos.unknownOptions(e);
        if (typos.isEmpty()) {
            terminal.say(firstLetterSmall(e.getMessage()));
        }
        typos.forEach(terminal::say);
        terminal.say("see 'enlightenment help" + (topic.isEmpty() ? "" : " " + topic) + "'");
        return CliException.WRONG_INPUT;
    }

    private static String firstLetterSmall(String message) {
        return message.isEmpty() ? message : Character.toLowerCase(message.charAt(0)) + message.substring(1);
    }

    /** Says every problem of a scene. */
    void problems(SceneException e) {
        for (SceneException.Problem p : e.problems()) {
            if (p.file().isEmpty()) {
                terminal.say(p.toString());
            } else {
                terminal.note(p.toString());
            }
        }
    }

    /** The same problems, with the file where they did not name one. */
    static SceneException inFile(String file, SceneException e) {
        List<SceneException.Problem> problems = new ArrayList<>();
        for (SceneException.Problem p : e.problems()) {
            problems.add(p.file().isEmpty() ? new SceneException.Problem(file, 0, 0, p.pointer(), p.message()) : p);
        }
        return new SceneException(problems);
    }

    /** A value that turned out to be of no use only when the scene in this file was put together. */
    static SceneException inFile(String file, InvalidValueException e) {
        return new SceneException(
                List.of(new SceneException.Problem(file, 0, 0, e.key().isEmpty() ? "" : "/" + e.key(), e.problem())));
    }

    /** What a failed access to a file is about, in words. */
    static String describe(IOException e) {
        if (e instanceof FileSystemException f && f.getFile() != null) {
            String reason = f.getReason();
            if (reason == null) {
                reason = f instanceof NoSuchFileException
                        ? "there is no such file or folder"
                        : f instanceof AccessDeniedException
                                ? "access is denied"
                                : f instanceof FileAlreadyExistsException
                                        ? "it exists already"
                                        : f.getClass().getSimpleName();
            }
            return f.getFile() + ": " + reason;
        }
        return e.getMessage() == null ? e.getClass().getSimpleName() : e.getMessage();
    }
}
