package enlightenment.net.secure;

import enlightenment.file.TemporaryFile;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.Key;
import java.security.KeyStore;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * Makes a certificate that vouches for itself, and its private key. The JDK can do so with its tool {@code keytool} only, which
 * every Java runtime has; it writes keystores, of which we take the contents.
 */
public final class OwnCertificate {
    private static final String PASSWORD_VARIABLE = "ENLIGHTENMENT_STORE_PASSWORD";
    private static final String ALIAS = "server";
    private static final int LINE = 64;

    /** As keytool puts it: a day ago, as the clocks of workers may be late. */
    private static final String START = "-1d";

    private static final int VALID_DAYS = 3650;
    private static final long KEYTOOL_TIMEOUT_SECONDS = 60;

    private OwnCertificate() {}

    /** The tool of the Java that runs us. */
    public static Path keytool() {
        Path bin = Path.of(System.getProperty("java.home"), "bin");
        Path windows = bin.resolve("keytool.exe");
        return Files.exists(windows) ? windows : bin.resolve("keytool");
    }

    /**
     * Writes a PEM file of a new certificate, valid for ten years, and its private key, which only the owner may read.
     *
     * @throws IOException if keytool is not there or fails, or the file cannot be written or exists
     */
    static void make(Path file, Path keytool) throws IOException {
        String password = SecretFile.random();
        Path shared = Path.of(System.getProperty("java.io.tmpdir"));
        TemporaryFile.clean(shared);
        try (TemporaryFile temporary = TemporaryFile.in(shared, SecretFile.ownersOnly(shared))) {
            Path folder = temporary.folder();
            Path store = folder.resolve("store.p12");
            run(file, command(keytool, store), password, folder.resolve("words"));
            SecretFile.create(file, pem(store, password.toCharArray()));
        }
    }

    private static List<String> command(Path keytool, Path store) {
        List<String> command = new ArrayList<>();
        command.addAll(List.of(keytool.toString(), "-genkeypair", "-alias", ALIAS, "-dname", "CN=enlightenment"));
        command.addAll(List.of("-keyalg", "EC", "-groupname", "secp256r1", "-sigalg", "SHA256withECDSA"));
        command.addAll(List.of("-startdate", START, "-validity", Integer.toString(VALID_DAYS)));
        // The password is not on the command line, which others can see.
        command.addAll(List.of("-storetype", "PKCS12", "-storepass:env", PASSWORD_VARIABLE));
        command.addAll(List.of("-keystore", store.toString(), "-J-Duser.language=en"));
        return command;
    }

    private static void run(Path file, List<String> command, String password, Path words) throws IOException {
        String failed = file + ": no certificate can be made: ";
        ProcessBuilder builder =
                new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(words.toFile());
        builder.environment().put(PASSWORD_VARIABLE, password);
        Process process;
        try {
            process = builder.start();
        } catch (IOException e) {
            throw new IOException(
                    failed + command.get(0)
                            + " cannot be started; make certificate and key elsewhere, and give them with"
                            + " --tls-cert and --tls-key",
                    e);
        }
        try {
            process.getOutputStream().close();
            if (!process.waitFor(KEYTOOL_TIMEOUT_SECONDS, TimeUnit.SECONDS)) {
                throw new IOException(failed + "keytool does not end");
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException(failed + "interrupted", e);
        } finally {
            process.destroyForcibly();
        }
        if (process.exitValue() != 0) {
            String said = Files.readString(words, StandardCharsets.ISO_8859_1).strip();
            throw new IOException(
                    failed + "keytool says: " + said.lines().findFirst().orElse("nothing"));
        }
    }

    private static String pem(Path store, char[] password) throws IOException {
        try (InputStream in = Files.newInputStream(store)) {
            KeyStore keys = KeyStore.getInstance("PKCS12");
            keys.load(in, password);
            Key key = keys.getKey(ALIAS, password);
            return block("CERTIFICATE", keys.getCertificate(ALIAS).getEncoded())
                    + block("PRIVATE KEY", key.getEncoded());
        } catch (GeneralSecurityException e) {
            throw new IOException("keytool made a keystore that cannot be used: " + e.getMessage(), e);
        }
    }

    private static String block(String kind, byte[] der) {
        String text = Base64.getMimeEncoder(LINE, new byte[] {'\n'}).encodeToString(der);
        return "-----BEGIN " + kind + "-----\n" + text + "\n-----END " + kind + "-----\n";
    }
}
