package enlightenment.net.secure;

import enlightenment.file.ContentHash;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * The secrets by which a server proves its identity.
 *
 * @param tls null for none
 * @param token the shared secret
 */
public record Secrets(Tls tls, byte[] token) {
    /**
     * The files of a server's secrets.
     *
     * @param token made if there is no such file; empty for no token
     * @param certificate empty for no TLS
     * @param privateKey of that certificate; may be the same file
     * @param makesCertificate whether certificate and key are made if there is no such file
     * @param keytool the program that makes them
     */
    public record Sources(
            Optional<Path> token,
            Optional<Path> certificate,
            Optional<Path> privateKey,
            boolean makesCertificate,
            Path keytool) {}

    /**
     * Reads the secrets; makes those that are to be made, and tells of it.
     *
     * @throws IOException if a file cannot be used or made; the message names it
     */
    public static Secrets open(Sources sources, Consumer<String> log) throws IOException {
        byte[] token = Token.NONE;
        if (sources.token.isPresent()) {
            Path file = sources.token.get();
            if (Files.notExists(file)) {
                Token.make(file);
                log.accept("made a new secret token: " + file);
            }
            token = Token.read(file);
            SecretFile.warnIfOpen(file, log);
        }
        return new Secrets(tls(sources, log), token);
    }

    /** The hash of our certificate, which proofs are bound to. */
    public ContentHash certificateHash() {
        return tls == null ? Tls.noCertificate() : tls.certificate();
    }

    /** The hash of the certificate that a worker may pin: 64 hexadecimal digits; empty without TLS. */
    public String pin() {
        return tls == null ? "" : tls.certificate().toString();
    }

    private static Tls tls(Sources sources, Consumer<String> log) throws IOException {
        if (sources.certificate.isEmpty()) {
            return null;
        }
        Path certificate = sources.certificate.get();
        Path key = sources.privateKey.orElseThrow();
        if (sources.makesCertificate && Files.notExists(certificate)) {
            OwnCertificate.make(certificate, sources.keytool);
            log.accept("made a new certificate and its private key: " + certificate);
        }
        Tls tls = Tls.server(certificate, key);
        SecretFile.warnIfOpen(key, log);
        if (tls.validUntil().isBefore(Instant.now())) {
            LocalDate end = LocalDate.ofInstant(tls.validUntil(), ZoneOffset.UTC);
            log.accept(certificate + ": the certificate expired on " + end
                    + ": workers that check it (--tls-ca) refuse it, those that pin it (--pin) do not mind");
        }
        return tls;
    }
}
