package enlightenment.net.secure;

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
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Timeout(600)
class SecretsTest {
    /** Where a server has made its secrets; running keytool takes long, so that it is done once. */
    @TempDir
    static Path made;

    private static final List<String> MAKING = new ArrayList<>();
    private static Secrets first;
    private static Instant before;

    @TempDir
    Path folder;

    private final List<String> log = new ArrayList<>();

    @BeforeAll
    static void make() throws IOException {
        before = Instant.now();
        first = Secrets.open(madeSources(), MAKING::add);
    }

    private static Secrets.Sources madeSources() {
        return own(made.resolve("tls.pem"), OwnCertificate.keytool(), Optional.of(made.resolve("token")));
    }

    /** A certificate that is made where there is none. */
    private static Secrets.Sources own(Path tls, Path keytool, Optional<Path> token) {
        return new Secrets.Sources(token, Optional.of(tls), Optional.of(tls), true, keytool);
    }

    private static Secrets.Sources own(Path tls) {
        return own(tls, OwnCertificate.keytool(), Optional.empty());
    }

    private static Secrets.Sources given(Path certificate, Path key) {
        return new Secrets.Sources(
                Optional.empty(), Optional.of(certificate), Optional.of(key), false, OwnCertificate.keytool());
    }

    private static Secrets.Sources token(Path file) {
        return new Secrets.Sources(
                Optional.of(file), Optional.empty(), Optional.empty(), false, OwnCertificate.keytool());
    }

    private Secrets open(Secrets.Sources sources) throws IOException {
        return Secrets.open(sources, log::add);
    }

    private String failure(Secrets.Sources sources) {
        return assertThrows(IOException.class, () -> open(sources)).getMessage();
    }

    private Path file(String name) {
        return folder.resolve(name);
    }

    private Path resource(String name) throws IOException {
        Path file = file(name);
        Files.copy(SecretsTest.class.getResourceAsStream("/net/" + name), file);
        return file;
    }

    private static void assertOwnersOnly(Path file) throws IOException {
        if (file.getFileSystem().supportedFileAttributeViews().contains("posix")) {
            assertEquals("rw-------", PosixFilePermissions.toString(Files.getPosixFilePermissions(file)));
        }
    }

    @Test
    void certificateAndTokenAreMadeOnceAndKept() throws IOException {
        assertTrue(MAKING.stream().anyMatch(line -> line.contains("made a new certificate")), MAKING.toString());
        assertTrue(MAKING.stream().anyMatch(line -> line.contains("made a new secret token")), MAKING.toString());
        assertOwnersOnly(made.resolve("tls.pem"));
        assertOwnersOnly(made.resolve("token"));
        Secrets second = open(madeSources());
        assertEquals(List.of(), log);
        assertEquals(first.certificateHash(), second.certificateHash());
        assertArrayEquals(first.token(), second.token());
        try (Stream<Path> files = Files.list(made)) {
            assertEquals(2, files.count());
        }
    }

    @Test
    void everyTokenAndCertificateIsAnother() throws IOException {
        Secrets other = open(own(file("b.pem"), OwnCertificate.keytool(), Optional.of(file("b"))));
        assertNotEquals(first.certificateHash(), other.certificateHash());
        assertFalse(java.util.Arrays.equals(first.token(), other.token()));
        // 128 bits, four to a character.
        assertEquals(32, first.token().length);
    }

    @Test
    void theCertificateHoldsFromYesterdayForTenYears() throws Exception {
        X509Certificate certificate = (X509Certificate) CertificateFactory.getInstance("X.509")
                .generateCertificate(new ByteArrayInputStream(Files.readAllBytes(made.resolve("tls.pem"))));
        certificate.verify(certificate.getPublicKey());
        Instant start = certificate.getNotBefore().toInstant();
        assertTrue(start.isAfter(before.minus(25, ChronoUnit.HOURS)), "from " + start);
        assertTrue(start.isBefore(Instant.now().minus(23, ChronoUnit.HOURS)), "from " + start);
        assertTrue(certificate.getNotAfter().toInstant().isAfter(before.plus(3648, ChronoUnit.DAYS)));
    }

    @Test
    void anExpiredCertificateIsToldOf() throws IOException {
        open(own(resource("expired.pem")));
        assertTrue(
                log.stream().anyMatch(line -> line.contains("the certificate expired on 2020-01-02")), log::toString);
    }

    @Test
    void withoutAKeytoolOrWithAStrangeOneTheMessageSaysWhatToDo() {
        String none = failure(own(file("tls.pem"), file("keytool"), Optional.empty()));
        assertTrue(none.contains("tls.pem: no certificate can be made: ") && none.contains("--tls-cert"), none);
        // The Java launcher knows none of keytool's options.
        Path java = Path.of(System.getProperty("java.home"), "bin", "java");
        String strange = failure(own(file("tls.pem"), java, Optional.empty()));
        assertTrue(strange.contains("keytool says: ") && strange.contains("-genkeypair"), strange);
        assertFalse(Files.exists(file("tls.pem")));
    }

    @Test
    void aFolderThatIsNotThereIsNamed() {
        Path missing = file("none");
        assertTrue(failure(token(missing.resolve("token"))).endsWith("there is no folder " + missing));
        assertThrows(IOException.class, () -> SecretFile.create(missing.resolve("tls.pem"), "x"));
    }

    @Test
    void aFolderThatIsWriteProtectedIsNamed() throws IOException {
        Path locked = Files.createDirectory(file("locked"));
        assumeTrue(locked.toFile().setWritable(false) && !Files.isWritable(locked), "not as root");
        assertTrue(failure(token(locked.resolve("token"))).endsWith("no permission to write to the folder " + locked));
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
        assertTrue(failure(own(scene)).startsWith(scene + ": is no PEM file"));
        assertEquals("{ \"name\": \"no secret\" }", Files.readString(scene));
    }

    @Test
    void encryptedKeysAndKeysOfOtherCertificatesAreRefusedAtTheStart() throws IOException {
        Path one = resource("self-signed.pem");
        Path two = resource("expired.pem");
        String other = failure(given(one, two));
        assertTrue(other.contains("expired.pem: does not go with") && other.contains("another certificate"), other);
        Files.writeString(one, Files.readString(one).replace("PRIVATE KEY", "ENCRYPTED PRIVATE KEY"));
        String encrypted = failure(own(one));
        assertTrue(encrypted.contains("the private key is encrypted"), encrypted);
    }

    @Test
    void shortTokensAndFilesThatAreNoKeysAreRefused() throws IOException {
        Path small = Files.writeString(file("small"), "0123456789abcde\n");
        assertTrue(failure(token(small)).contains("at least 16 characters, not 15"));
        Path certificate = resource("server-cert.pem");
        Path key = resource("server-key.pem");
        assertTrue(failure(given(certificate, certificate)).contains("holds no \"BEGIN PRIVATE KEY\""));
        assertTrue(failure(given(key, key)).contains("is no PEM file of certificates"));
    }

    @Test
    void secretsThatOthersMayReadAreToldOf() throws IOException {
        Path token = Files.writeString(file("token"), "0123456789abcdef");
        assumeTrue(token.getFileSystem().supportedFileAttributeViews().contains("posix"));
        Files.setPosixFilePermissions(token, PosixFilePermissions.fromString("rw-r-----"));
        open(token(token));
        assertTrue(
                log.stream().anyMatch(line -> line.contains("others on this machine may read or change this secret")),
                log::toString);
        log.clear();
        Files.setPosixFilePermissions(token, PosixFilePermissions.fromString("r--------"));
        open(token(token));
        assertEquals(List.of(), log);
    }
}
