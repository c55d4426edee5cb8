package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.cert.CertificateFactory;
import java.security.cert.X509Certificate;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Timeout(120)
class SecretsTest {
    @TempDir
    Path folder;

    private final List<String> log = new ArrayList<>();

    private Secrets open(ServerOptions.Builder options) throws IOException {
        return Secrets.open(options.build().secrets(), log::add);
    }

    private String failure(ServerOptions.Builder options) {
        return assertThrows(IOException.class, () -> open(options)).getMessage();
    }

    private boolean said(String words) {
        return log.stream().anyMatch(line -> line.contains(words));
    }

    private Path file(String name) {
        return folder.resolve(name);
    }

    private static void assertOwnersOnly(Path file) throws IOException {
        if (file.getFileSystem().supportedFileAttributeViews().contains("posix")) {
            assertEquals("rw-------", PosixFilePermissions.toString(Files.getPosixFilePermissions(file)));
        }
    }

    @Test
    void certificateAndTokenAreMadeOnceAndKept() throws IOException {
        ServerOptions.Builder options =
                ServerOptions.builder().tls(file("tls.pem")).tokenFile(file("token"));
        Secrets first = open(options);
        assertTrue(said("made a new certificate"), log.toString());
        assertTrue(said("made a new secret token"), log.toString());
        assertOwnersOnly(file("tls.pem"));
        assertOwnersOnly(file("token"));
        log.clear();
        Secrets second = open(options);
        assertEquals(List.of(), log);
        assertEquals(first.certificateHash(), second.certificateHash());
        assertArrayEquals(first.token(), second.token());
        try (Stream<Path> files = Files.list(folder)) {
            assertEquals(2, files.count());
        }
    }

    @Test
    void everyTokenAndCertificateIsAnother() throws IOException {
        Secrets a = open(ServerOptions.builder().tls(file("a.pem")).tokenFile(file("a")));
        Secrets b = open(ServerOptions.builder().tls(file("b.pem")).tokenFile(file("b")));
        assertNotEquals(a.certificateHash(), b.certificateHash());
        assertFalse(java.util.Arrays.equals(a.token(), b.token()));
        // 128 bits, four to a character.
        assertEquals(32, a.token().length);
    }

    @Test
    void theCertificateHoldsFromYesterdayForTenYears() throws Exception {
        open(ServerOptions.builder().tls(file("tls.pem")));
        X509Certificate made = (X509Certificate) CertificateFactory.getInstance("X.509")
                .generateCertificate(new ByteArrayInputStream(Files.readAllBytes(file("tls.pem"))));
        Instant now = Instant.now();
        made.verify(made.getPublicKey());
        assertTrue(made.getNotBefore().toInstant().isBefore(now.minus(23, ChronoUnit.HOURS)));
        assertTrue(made.getNotAfter().toInstant().isAfter(now.plus(3648, ChronoUnit.DAYS)));
    }

    @Test
    void aServerThatMadeItsSecretsIsJoinedWithTokenAndPin() throws Exception {
        Path token = file("token");
        ServerOptions.Builder options = Farm.options().tls(file("tls.pem")).tokenFile(token);
        try (Farm farm = new Farm(options).begin()) {
            farm.join(Farm.worker(1).pin(farm.server.pin()).tokenFile(token));
            farm.join(Farm.worker(1).pin(farm.server.pin()).token(Files.readString(token)));
            assertArrayEquals(Farm.alone(), Farm.png(farm.result().image()));
            for (var worker : farm.workers) {
                assertTrue(worker.get(10, TimeUnit.SECONDS).isDone());
            }
        }
    }

    @Test
    void anExpiredCertificateIsToldOfAndStillPinned() throws Exception {
        OwnCertificate.make(file("old.pem"), OwnCertificate.keytool(), new OwnCertificate.Validity("-10d", 1));
        try (Farm farm = new Farm(Farm.options().tls(file("old.pem"))).begin()) {
            assertTrue(farm.logHas("the certificate expired on "), farm.log.toString());
            RenderWorker.Outcome refused = farm.join(
                            Farm.worker(1).authorities(file("old.pem")).reconnectSeconds(0))
                    .get(20, TimeUnit.SECONDS);
            assertFalse(refused.isDone());
            farm.join(Farm.worker(1).pin(farm.server.pin()));
            assertArrayEquals(Farm.alone(), Farm.png(farm.result().image()));
        }
    }

    @Test
    void withoutAKeytoolOrWithAStrangeOneTheMessageSaysWhatToDo() {
        ServerOptions.Builder options = ServerOptions.builder().tls(file("tls.pem"));
        String none = failure(options.keytool(file("keytool")));
        assertTrue(none.contains("tls.pem: no certificate can be made: ") && none.contains("--tls-cert"), none);
        // The Java launcher knows none of keytool's options.
        String strange = failure(options.keytool(Path.of(System.getProperty("java.home"), "bin", "java")));
        assertTrue(strange.contains("keytool says: ") && strange.contains("-genkeypair"), strange);
        assertFalse(Files.exists(file("tls.pem")));
    }

    @Test
    void aFolderThatIsNotThereIsNamed() {
        String missing = file("none").toString();
        assertTrue(failure(ServerOptions.builder().tokenFile(Path.of(missing, "token")))
                .endsWith("there is no folder " + missing));
        assertTrue(failure(ServerOptions.builder().tls(Path.of(missing, "tls.pem")))
                .endsWith("there is no folder " + missing));
    }

    @Test
    void aFolderThatIsWriteProtectedIsNamed() throws IOException {
        Path locked = Files.createDirectory(file("locked"));
        assumeTrue(locked.toFile().setWritable(false) && !Files.isWritable(locked), "not as root");
        assertTrue(failure(ServerOptions.builder().tokenFile(locked.resolve("token")))
                .endsWith("no permission to write to the folder " + locked));
    }

    @Test
    void aSecretThatAppearsMeanwhileIsNotWrittenOver() throws IOException {
        Path file = Files.writeString(file("token"), "the token of another server");
        String message = assertThrows(IOException.class, () -> Token.make(file)).getMessage();
        assertTrue(message.contains("by somebody else just now"), message);
        assertEquals("the token of another server", Files.readString(file));
    }

    @Test
    void filesOfAnotherKindAreLeftAsTheyAre() throws IOException {
        Path scene = Files.writeString(file("scene.json"), "{ \"name\": \"no secret\" }");
        assertTrue(failure(ServerOptions.builder().tls(scene)).startsWith(scene + ": is no PEM file"));
        assertEquals("{ \"name\": \"no secret\" }", Files.readString(scene));
    }

    @Test
    void encryptedKeysAndKeysOfOtherCertificatesAreRefusedAtTheStart() throws IOException {
        open(ServerOptions.builder().tls(file("a.pem")));
        open(ServerOptions.builder().tls(file("b.pem")));
        String other = failure(ServerOptions.builder().tls(file("a.pem"), file("b.pem")));
        assertTrue(other.contains("b.pem: does not go with") && other.contains("another certificate"), other);
        String text = Files.readString(file("a.pem"));
        Files.writeString(file("a.pem"), text.replace("PRIVATE KEY", "ENCRYPTED PRIVATE KEY"));
        String encrypted = failure(ServerOptions.builder().tls(file("a.pem")));
        assertTrue(encrypted.contains("the private key is encrypted"), encrypted);
    }

    @Test
    void secretsThatOthersMayReadAreToldOf() throws IOException {
        Path token = Files.writeString(file("token"), "0123456789abcdef");
        assumeTrue(token.getFileSystem().supportedFileAttributeViews().contains("posix"));
        Files.setPosixFilePermissions(token, PosixFilePermissions.fromString("rw-r-----"));
        open(ServerOptions.builder().tokenFile(token));
        assertTrue(said("others on this machine may read or change this secret"), log.toString());
        log.clear();
        Files.setPosixFilePermissions(token, PosixFilePermissions.fromString("r--------"));
        open(ServerOptions.builder().tokenFile(token));
        assertEquals(List.of(), log);
    }

    @Test
    void aWorkerMakesNoTokenAndSaysWhereItComesFrom() {
        WorkerOptions.Builder options = WorkerOptions.builder().tokenFile(file("token"));
        String message = assertThrows(
                        IOException.class, () -> RenderWorker.run("127.0.0.1", 1, options.build(), () -> true))
                .getMessage();
        assertTrue(message.endsWith("there is no such file; copy the server's token to it"), message);
        assertFalse(Files.exists(file("token")));
        assertThrows(
                IllegalArgumentException.class, () -> WorkerOptions.builder().token("0123456789abcde\n"));
    }
}
