package enlightenment.cli.store;

import enlightenment.cli.option.CommandFiles;
import enlightenment.cli.terminal.CliException;
import enlightenment.file.FilePlace;
import enlightenment.file.InputFile;
import enlightenment.store.StoreAddress;
import enlightenment.store.StoreLogin;
import enlightenment.text.PathText;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Option;

/** The options that say who opens a store. A password is never one of them, since others can see those. */
final class StoreAccess {
    private static final String VARIABLE = "ENLIGHTENMENT_STORE_PASSWORD";
    private static final int LONGEST_PASSWORD = 4096;

    @Option(names = "--store-user", paramLabel = "NAME", description = "user of the database of the store")
    private String user;

    @Option(
            names = "--store-password-file",
            paramLabel = "FILE",
            description = "file with the user's password, in place of " + VARIABLE)
    private Path passwordFile;

    StoreAccess() {}

    /** The store of this name. */
    static StoreAddress address(String text) {
        try {
            StoreAddress address = StoreAddress.of(text);
            boolean isRelative =
                    address.file().filter(file -> !file.isAbsolute()).isPresent();
            if (isRelative && PathText.problemOfWorkingFolder().isPresent()) {
                throw CliException.wrongUsage(PathText.problemOfWorkingFolder().get());
            }
            return address;
        } catch (IllegalArgumentException e) {
            throw CliException.wrongUsage(e.getMessage());
        }
    }

    /** Adds the files of a store that is read. */
    static void reads(StoreAddress address, CommandFiles files) throws IOException {
        address.file().ifPresent(file -> files.reads("the store", file));
        beside(address).forEach(file -> files.reads("what lies beside the store", file));
    }

    /** Adds the files of a store that is written. */
    static void writes(StoreAddress address, CommandFiles files) throws IOException {
        address.file().ifPresent(file -> files.writes("--store", file));
        beside(address).forEach(file -> files.makes("--store", file));
    }

    private static List<Path> beside(StoreAddress address) throws IOException {
        return address.file().isEmpty()
                ? List.of()
                : StoreAddress.beside(FilePlace.of(address.file().get()));
    }

    /** Adds the file of the password, which is read. */
    void register(CommandFiles files) {
        files.reads("the file of --store-password-file", passwordFile);
    }

    StoreLogin login() throws IOException {
        return new StoreLogin(Optional.ofNullable(user), password());
    }

    private Optional<String> password() throws IOException {
        if (passwordFile == null) {
            return Optional.ofNullable(System.getenv(VARIABLE));
        }
        byte[] bytes = InputFile.start(passwordFile, LONGEST_PASSWORD + 1);
        String text = new String(bytes, StandardCharsets.UTF_8);
        String password = text.lines().findFirst().orElse("");
        if (bytes.length > LONGEST_PASSWORD || password.isEmpty()) {
            throw CliException.failed(passwordFile + ": no password: its first line is to be one");
        }
        return Optional.of(password);
    }
}
