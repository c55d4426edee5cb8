package enlightenment.net;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.time.LocalDate;
import java.time.ZoneOffset;

/**
 * What a server proves itself with.
 *
 * @param tls null for none
 * @param token the shared secret
 */
record Secrets(Tls tls, byte[] token) {
    /** Reads the files of a server's options; makes those that are to be made, and tells of it. */
    static Secrets open(ServerOptions options) throws IOException {
        byte[] token = Token.NONE;
        if (options.tokenFile.isPresent()) {
            Path file = options.tokenFile.get();
            if (Files.notExists(file)) {
                Token.make(file);
                options.log.accept("made a new secret token: " + file);
            }
            token = Token.read(file);
            SecretFile.warnIfOpen(file, options.log);
        }
        return new Secrets(tls(options), token);
    }

    /** The hash of our certificate, which proofs are bound to. */
    ContentHash certificate() {
        return tls == null ? Tls.noCertificate() : tls.certificate();
    }

    private static Tls tls(ServerOptions options) throws IOException {
        if (options.certificate.isEmpty()) {
            return null;
        }
        Path certificate = options.certificate.get();
        Path key = options.privateKey.orElseThrow();
        if (options.makesCertificate && Files.notExists(certificate)) {
            OwnCertificate.make(certificate, options.keytool, OwnCertificate.Validity.USUAL);
            options.log.accept("made a new certificate and its private key: " + certificate);
        }
        Tls tls = Tls.server(certificate, key);
        SecretFile.warnIfOpen(key, options.log);
        if (tls.validUntil().isBefore(Instant.now())) {
            LocalDate end = LocalDate.ofInstant(tls.validUntil(), ZoneOffset.UTC);
            options.log.accept(certificate + ": the certificate expired on " + end
                    + ": workers that check it (--tls-ca) refuse it, those that pin it (--pin) do not mind");
        }
        return tls;
    }
}
