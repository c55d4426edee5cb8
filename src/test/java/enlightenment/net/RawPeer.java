package enlightenment.net;

import enlightenment.job.Build;
import enlightenment.net.job.Canary;
import enlightenment.net.protocol.Frames;
import enlightenment.net.protocol.Limits;
import enlightenment.net.protocol.Message;
import enlightenment.net.schedule.Peers;
import enlightenment.net.secure.Handshake;
import enlightenment.net.secure.Tls;
import java.io.Closeable;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.util.HexFormat;

/** Somebody who speaks to a server byte by byte or message by message, rightly or wrongly. */
public final class RawPeer implements Closeable {
    final Socket socket;
    private final InputStream in;

    public RawPeer(int port) throws IOException {
        socket = new Socket("127.0.0.1", port);
        socket.setSoTimeout(1_000 * Farm.TIMEOUT_SECONDS);
        socket.setTcpNoDelay(true);
        in = socket.getInputStream();
    }

    void bytes(byte[] bytes) throws IOException {
        socket.getOutputStream().write(bytes);
    }

    /** The machine as the server's log calls it. */
    static String called(String machine, Farm farm) {
        return "machine " + Peers.machine(machine, farm.server.round().job().hash());
    }

    void bytes(String hex) throws IOException {
        bytes(HexFormat.of().parseHex(hex));
    }

    public void send(Message message) throws IOException {
        DataOutputStream out = new DataOutputStream(socket.getOutputStream());
        Frames.write(out, message, Limits.FRAME);
        out.flush();
    }

    Message receive() throws IOException {
        return Frames.read(in, Limits.FRAME).orElse(null);
    }

    /** The next message of this kind; others are let pass. */
    <T extends Message> T receive(Class<T> kind) throws IOException {
        while (true) {
            Message message = receive();
            if (message == null) {
                throw new IOException("closed before a " + kind.getSimpleName());
            }
            if (kind.isInstance(message)) {
                return kind.cast(message);
            }
        }
    }

    /** Reads until the server closes the connection, and fails if it does not for as long as anything may take. */
    void awaitClose() {
        try {
            while (in.read() >= 0) {
                continue;
            }
        } catch (java.net.SocketTimeoutException e) {
            throw new AssertionError("the server does not close the connection", e);
        } catch (IOException e) {
            // Closed with a reset.
            return;
        }
    }

    static Message.Hello hello(String machine) {
        return new Message.Hello(
                Message.MAGIC,
                Message.PROTOCOL,
                Message.PROTOCOL,
                Build.number(),
                machine,
                1,
                Canary.hash(),
                new byte[Handshake.NONCE_BYTES]);
    }

    /** Joins as an honest worker would; gives the job. */
    Message.Job join(String machine, byte[] token) throws IOException {
        Message.Job job = enter(machine, token);
        send(ready(job, machine));
        return job;
    }

    static Message.Ready ready(Message.Job job, String machine) {
        return new Message.Ready(
                job.job(),
                Peers.secret(machine),
                Handshake.hmac(Peers.secret(machine), job.job().toBytes()));
    }

    Message.Job enter(String machine, byte[] token) throws IOException {
        prove(hello(machine), token);
        return receive(Message.Job.class);
    }

    /** Says hello and proves that it knows the token. */
    void prove(Message.Hello hello, byte[] token) throws IOException {
        send(hello);
        Message.Challenge challenge = receive(Message.Challenge.class);
        send(new Message.Proof(
                Handshake.proof(Handshake.Side.WORKER, token, hello.nonce(), challenge.nonce(), Tls.noCertificate())));
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }
}
