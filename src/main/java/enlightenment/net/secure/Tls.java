package enlightenment.net.secure;

import enlightenment.file.ContentHash;
import enlightenment.file.InputFile;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyFactory;
import java.security.KeyStore;
import java.security.PrivateKey;
import java.security.PublicKey;
import java.security.Signature;
import java.security.cert.Certificate;
import java.security.cert.CertificateException;
import java.security.cert.CertificateFactory;
import java.security.cert.X509Certificate;
import java.security.spec.InvalidKeySpecException;
import java.security.spec.PKCS8EncodedKeySpec;
import java.time.Instant;
import java.util.Base64;
import java.util.Collection;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.net.ssl.KeyManagerFactory;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLHandshakeException;
import javax.net.ssl.SSLParameters;
import javax.net.ssl.SSLSocket;
import javax.net.ssl.TrustManager;
import javax.net.ssl.TrustManagerFactory;
import javax.net.ssl.X509TrustManager;

/** TLS 1.3 with the means of the JDK: one side's sockets, and the hash of the server's certificate. */
public final class Tls {
    private static final String[] PROTOCOLS = {"TLSv1.3"};
    private static final Pattern KEY =
            Pattern.compile("-----BEGIN PRIVATE KEY-----([^-]*)-----END PRIVATE KEY-----", Pattern.DOTALL);
    private static final Pattern CERTIFICATE =
            Pattern.compile("-----BEGIN CERTIFICATE-----[^-]*-----END CERTIFICATE-----", Pattern.DOTALL);
    private static final ContentHash NONE = new ContentHash(0, 0, 0, 0);

    private final SSLContext context;
    private final ContentHash certificate;
    private final boolean checksName;

    private final Instant validUntil;

    private Tls(SSLContext context, ContentHash certificate, boolean checksName, Instant validUntil) {
        this.context = context;
        this.certificate = certificate;
        this.checksName = checksName;
        this.validUntil = validUntil;
    }

    /** The stand-in for the certificate's hash where there is no certificate. */
    public static ContentHash noCertificate() {
        return NONE;
    }

    /**
     * A server's side.
     *
     * @param chain PEM file of the certificate and those that vouch for it
     * @param key PEM file of its private key (PKCS #8, not encrypted); may be the same file
     * @throws IOException if a file cannot be used; the message says why
     */
    static Tls server(Path chain, Path key) throws IOException {
        Collection<? extends Certificate> certificates = certificates(chain);
        Certificate own = certificates.iterator().next();
        char[] password = {'x'};
        try {
            KeyStore store = KeyStore.getInstance(KeyStore.getDefaultType());
            store.load(null, null);
            PrivateKey secret = privateKey(key, own.getPublicKey().getAlgorithm());
            requirePair(secret, own.getPublicKey());
            store.setKeyEntry("server", secret, password, certificates.toArray(new Certificate[0]));
            KeyManagerFactory managers = KeyManagerFactory.getInstance(KeyManagerFactory.getDefaultAlgorithm());
            managers.init(store, password);
            SSLContext context = SSLContext.getInstance("TLS");
            context.init(managers.getKeyManagers(), null, null);
            return new Tls(context, ContentHash.of(own.getEncoded()), false, validUntil(own));
        } catch (GeneralSecurityException e) {
            throw new IOException(key + ": does not go with " + chain + ": " + e.getMessage(), e);
        }
    }

    /** A worker's side that trusts what these certificates vouch for, under the name that was connected to. */
    public static Tls trusting(Path authorities) throws IOException {
        try {
            KeyStore store = KeyStore.getInstance(KeyStore.getDefaultType());
            store.load(null, null);
            int n = 0;
            for (Certificate authority : certificates(authorities)) {
                store.setCertificateEntry("ca" + n++, authority);
            }
            TrustManagerFactory managers = TrustManagerFactory.getInstance(TrustManagerFactory.getDefaultAlgorithm());
            managers.init(store);
            SSLContext context = SSLContext.getInstance("TLS");
            context.init(null, managers.getTrustManagers(), null);
            return new Tls(context, NONE, true, Instant.MAX);
        } catch (GeneralSecurityException e) {
            throw new IOException(authorities + ": cannot be used: " + e.getMessage(), e);
        }
    }

    /** A worker's side that trusts the one certificate whose SHA-256 is this. */
    public static Tls pinned(ContentHash pin) {
        try {
            SSLContext context = SSLContext.getInstance("TLS");
            context.init(null, new TrustManager[] {new Pin(pin)}, null);
            return new Tls(context, NONE, false, Instant.MAX);
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException("every Java platform has TLS", e);
        }
    }

    /** The hash of our own certificate: what workers may pin. */
    ContentHash certificate() {
        return certificate;
    }

    /** Until when our own certificate holds; without end if there is none. */
    Instant validUntil() {
        return validUntil;
    }

    private static Instant validUntil(Certificate certificate) {
        return certificate instanceof X509Certificate x ? x.getNotAfter().toInstant() : Instant.MAX;
    }

    /** Fails unless what the one key signs holds for the other: else that would be noticed by the first worker only. */
    private static void requirePair(PrivateKey secret, PublicKey open) throws GeneralSecurityException {
        String algorithm = secret.getAlgorithm();
        if (!algorithm.equals("EC") && !algorithm.equals("RSA")) {
            return;
        }
        Signature signature = Signature.getInstance(algorithm.equals("EC") ? "SHA256withECDSA" : "SHA256withRSA");
        signature.initSign(secret);
        signature.update(algorithm.getBytes(StandardCharsets.US_ASCII));
        byte[] signed = signature.sign();
        signature.initVerify(open);
        signature.update(algorithm.getBytes(StandardCharsets.US_ASCII));
        if (!signature.verify(signed)) {
            throw new GeneralSecurityException("it is the key of another certificate");
        }
    }

    /** The server shows a certificate that this worker is not to trust: our own decision, which no later try changes. */
    public static final class UntrustedException extends IOException {
        private static final long serialVersionUID = 1L;

        UntrustedException(String message, Throwable cause) {
            super(message, cause);
        }
    }

    private static void shakeHands(SSLSocket socket) throws IOException {
        try {
            socket.startHandshake();
        } catch (SSLHandshakeException e) {
            for (Throwable cause = e.getCause(); cause != null; cause = cause.getCause()) {
                if (cause instanceof CertificateException refused) {
                    throw new UntrustedException("the server's certificate is not trusted: " + refused.getMessage(), e);
                }
            }
            throw e;
        }
    }

    /**
     * TLS over a connection; for a worker with the name that it connected to, else null. Shakes hands.
     *
     * @throws UntrustedException if this side refuses the other's certificate; other failures may pass
     */
    public SSLSocket over(Socket plain, String host) throws IOException {
        SSLSocket socket = (SSLSocket)
                (host == null
                        ? context.getSocketFactory().createSocket(plain, null, true)
                        : context.getSocketFactory().createSocket(plain, host, plain.getPort(), true));
        SSLParameters parameters = socket.getSSLParameters();
        parameters.setProtocols(PROTOCOLS);
        if (checksName) {
            parameters.setEndpointIdentificationAlgorithm("HTTPS");
        }
        socket.setSSLParameters(parameters);
        shakeHands(socket);
        return socket;
    }

    /** The hash of the certificate that the other side showed. */
    public static ContentHash shown(SSLSocket socket) throws IOException {
        try {
            return ContentHash.of(socket.getSession().getPeerCertificates()[0].getEncoded());
        } catch (CertificateException e) {
            throw new IOException("the server's certificate cannot be used", e);
        }
    }

    private static Collection<? extends Certificate> certificates(Path file) throws IOException {
        try {
            byte[] bytes = certificatesAlone(InputFile.bytes(file));
            Collection<? extends Certificate> all =
                    CertificateFactory.getInstance("X.509").generateCertificates(new ByteArrayInputStream(bytes));
            if (all.isEmpty()) {
                throw new IOException(file + ": holds no certificate");
            }
            return all;
        } catch (CertificateException e) {
            throw new IOException(file + ": is no PEM file of certificates: " + e.getMessage(), e);
        }
    }

    /** Without the private key that may stand in the same PEM file. */
    private static byte[] certificatesAlone(byte[] file) {
        StringBuilder all = new StringBuilder();
        Matcher pem = CERTIFICATE.matcher(new String(file, StandardCharsets.ISO_8859_1));
        while (pem.find()) {
            all.append(pem.group()).append('\n');
        }
        return all.length() == 0 ? file : all.toString().getBytes(StandardCharsets.ISO_8859_1);
    }

    private static PrivateKey privateKey(Path file, String algorithm) throws IOException, GeneralSecurityException {
        String text = new String(InputFile.bytes(file), StandardCharsets.ISO_8859_1);
        Matcher pem = KEY.matcher(text);
        if (!pem.find()) {
            if (text.contains("ENCRYPTED")) {
                throw new IOException(file + ": the private key is encrypted; a server that starts on its own needs it"
                        + " without a password (openssl pkey -in FILE -out FILE, then chmod 600)");
            }
            throw new IOException(file + ": holds no \"BEGIN PRIVATE KEY\" (PKCS #8, not encrypted)");
        }
        try {
            byte[] der = Base64.getMimeDecoder().decode(pem.group(1));
            return KeyFactory.getInstance(algorithm).generatePrivate(new PKCS8EncodedKeySpec(der));
        } catch (IllegalArgumentException | InvalidKeySpecException e) {
            throw new IOException(file + ": is no private key for " + algorithm, e);
        }
    }

    /** Trusts one certificate. */
    private record Pin(ContentHash pin) implements X509TrustManager {
        @Override
        public void checkClientTrusted(X509Certificate[] chain, String type) throws CertificateException {
            throw new CertificateException("workers show no certificates");
        }

        @Override
        public void checkServerTrusted(X509Certificate[] chain, String type) throws CertificateException {
            ContentHash shown = ContentHash.of(chain[0].getEncoded());
            if (!shown.equals(pin)) {
                throw new CertificateException("it is " + shown + ", not " + pin + " as the pin says");
            }
        }

        @Override
        public X509Certificate[] getAcceptedIssuers() {
            return List.<X509Certificate>of().toArray(new X509Certificate[0]);
        }
    }
}
