package enlightenment.net.server;

import enlightenment.checkpoint.Origin;
import enlightenment.file.ContentHash;
import enlightenment.listen.ServerLog;
import enlightenment.listen.Strangers;
import enlightenment.net.job.Canary;
import enlightenment.net.protocol.Limits;
import enlightenment.net.protocol.Message;
import enlightenment.net.protocol.MessageChannel;
import enlightenment.net.protocol.ProtocolException;
import enlightenment.net.protocol.Timing;
import enlightenment.net.schedule.Event;
import enlightenment.net.secure.Handshake;
import enlightenment.net.secure.Secrets;
import enlightenment.text.Plain;
import java.io.IOException;
import java.net.Socket;
import java.security.SecureRandom;
import java.util.Set;
import javax.net.ssl.SSLException;

/** One connection to a server, from the first byte of a stranger to the last of a worker. One thread listens to it. */
public final class ServerConnection {
    private static final SecureRandom RANDOM = new SecureRandom();
    private static final int LONGEST_NAME = 80;

    private final long id;
    private final Host server;
    private final Socket plain;
    private final long opened = System.nanoTime();
    private volatile MessageChannel channel;
    private volatile Message.Hello hello;
    private volatile Message.Ready ready;
    private volatile String closedBecause = "";
    private volatile boolean isKnown;
    private volatile boolean isJoined;

    /** The services of a server that its connections use. For use by several threads at once. */
    public interface Host {
        /** The secrets by which the server proves its identity. */
        Secrets secrets();

        /** The deadlines of the two sides. */
        Timing timing();

        /** The version that both sides must have. */
        String version();

        /** The job that is rendered. */
        ServerJob job();

        ServerLog log();

        /** First guess of the speed of a worker of this name at this address, 1 if nothing is known. */
        double weight(String name, String address);

        /** The message that workers receive once this server ends, when it admits none any more. Null until then. */
        Message lastWord();

        /** Whether there is a place for the worker, which has proved that it knows the token. */
        boolean admit(ServerConnection connection);

        /** The worker has all that it needs. */
        void ready(ServerConnection connection);

        /** Passes an event to the coordinator, and performs the actions that follow. */
        void handle(Event event);

        /** The connection has ended; an empty reason is not logged. */
        void ended(ServerConnection connection, String reason);
    }

    ServerConnection(long id, Host server, Socket plain) {
        this.id = id;
        this.server = server;
        this.plain = plain;
    }

    /** Listens until the connection ends, and tells the server why it did. */
    void run() {
        String reason = "";
        try {
            MessageChannel made = open();
            channel = made;
            if (shakeHands(made)) {
                while (listen(made)) {
                    reason = "the connection was closed";
                }
            } else {
                while (made.receive() != null) {
                    // What comes after a refusal is let pass until the other side closes.
                    continue;
                }
            }
        } catch (ProtocolException e) {
            reason = "sent what is no message: " + e.getMessage();
        } catch (SSLException e) {
            reason = "TLS failed: " + e.getMessage();
        } catch (IOException | RuntimeException e) {
            reason = String.valueOf(e.getMessage());
        } catch (OutOfMemoryError e) {
            reason = "there are not memory and threads enough for it here: " + e.getMessage();
        } finally {
            end(reason);
        }
    }

    private MessageChannel open() throws IOException {
        plain.setTcpNoDelay(true);
        Socket socket =
                server.secrets().tls() == null ? plain : server.secrets().tls().over(plain, null);
        return new MessageChannel(plain, socket, server.timing(), "connection " + id);
    }

    private void end(String why) {
        MessageChannel mine = channel;
        String here = mine == null ? closedBecause : mine.reason();
        String reason = here.isEmpty() ? why : here;
        close(reason);
        server.ended(this, reason);
    }

    /** Whether a worker of ours is at the other side; it has been told the reason if not. */
    private boolean shakeHands(MessageChannel on) throws IOException {
        Message first = on.receive();
        if (!(first instanceof Message.Hello worker)) {
            throw new ProtocolException(first == null ? "nothing was said" : "no hello");
        }
        hello = worker;
        on.begin();
        if (worker.oldest() > Message.PROTOCOL || worker.newest() < Message.PROTOCOL) {
            refuse(
                    "the server speaks protocol " + Message.PROTOCOL + ", the worker " + worker.oldest() + ".."
                            + worker.newest() + ": install the same version on both",
                    false);
            return false;
        }
        byte[] nonce = new byte[Handshake.NONCE_BYTES];
        RANDOM.nextBytes(nonce);
        on.send(new Message.Challenge(Message.PROTOCOL, nonce));
        if (!(on.receive() instanceof Message.Proof proof)) {
            throw new ProtocolException("no proof");
        }
        ContentHash certificate = server.secrets().certificateHash();
        byte[] token = server.secrets().token();
        byte[] expected = Handshake.proof(Handshake.Side.WORKER, token, worker.nonce(), nonce, certificate);
        if (!Handshake.same(expected, proof.mac())) {
            refuse("the worker does not know the server's token (--token-file), or someone is in between", false);
            return false;
        }
        // From here on a refusal is believed, as it comes from who knows the token.
        Timing timing = server.timing();
        on.send(new Message.Welcome(
                Handshake.proof(Handshake.Side.SERVER, token, worker.nonce(), nonce, certificate),
                timing.heartbeatMillis(),
                timing.silenceMillis(),
                Limits.UNACKNOWLEDGED_TILES));
        return isAdmitted(on, worker);
    }

    private boolean isAdmitted(MessageChannel on, Message.Hello worker) {
        if (!server.admit(this)) {
            Message last = server.lastWord();
            if (last == null) {
                refuse("the server has as many workers as it can have", true);
            } else {
                on.sayLast(last);
            }
            return false;
        }
        String refusal = refusal(worker);
        if (refusal != null) {
            refuse(refusal, false);
            return false;
        }
        on.trust();
        ServerJob job = server.job();
        on.send(new Message.Job(job.hash(), job.tiles(), job.content().hashes()));
        return true;
    }

    private String refusal(Message.Hello worker) {
        if (!worker.build().equals(server.version())) {
            return "the server is version " + server.version() + ", the worker " + worker.build()
                    + ": install the same version on both";
        }
        if (!worker.arithmetic().equals(Canary.hash()) && !isUnproven(worker)) {
            return "the worker's machine computes other numbers than the server's (the canary tile differs)";
        }
        return null;
    }

    private static boolean isUnproven(Message.Hello worker) {
        return worker.arithmetic().equals(Canary.NOT_COMPUTED);
    }

    /** Handles one message; false at the end. After the last message was sent, others are ignored until the other side closes. */
    private boolean listen(MessageChannel on) throws IOException {
        Message message = on.receive();
        if (message instanceof Message.Bye bye) {
            throw new IOException(bye.reason());
        }
        if (message != null && !on.isLastSaid()) {
            hear(on, message);
        }
        return message != null;
    }

    private void hear(MessageChannel on, Message message) throws IOException {
        if (message instanceof Message.Heartbeat beat) {
            if (isJoined) {
                server.handle(new Event.Heard(id, Set.copyOf(beat.leases())));
            } else {
                on.send(new Message.Alive(
                        server.job().film().done(), server.job().tiles()));
            }
        } else if (message instanceof Message.Result result) {
            deliver(on, result);
        } else if (message instanceof Message.ContentRequest request) {
            on.sendWhenFree(content(request));
        } else if (message instanceof Message.Ready said
                && ready == null
                && said.job().equals(server.job().hash())) {
            ready = said;
            server.ready(this);
        } else {
            throw new ProtocolException(message.getClass().getSimpleName() + " is nothing that a worker says now");
        }
    }

    private void deliver(MessageChannel on, Message.Result result) {
        ServerJob job = server.job();
        if (!result.job().equals(job.hash()) || !isJoined || isTooEarly(job, result.tile())) {
            on.send(new Message.Acknowledge(result.tile()));
            return;
        }
        String problem = job.film().problem(result.tile(), result.data()).orElse(null);
        server.handle(
                problem == null
                        ? new Event.Delivered(
                                id, result.lease(), result.tile(), job.result(result.tile(), result.data()))
                        : new Event.Misbehaved(id, "tile " + result.tile() + ": " + problem));
    }

    /** Whether the tile is not offered yet: a worker of an earlier incarnation of this server may have rendered it. */
    private static boolean isTooEarly(ServerJob job, int tile) {
        return tile >= job.film().end() && tile < job.tiles();
    }

    private Message.Content content(Message.ContentRequest request) throws ProtocolException {
        byte[] content = server.job().content().content(request.content());
        if (content == null || request.offset() > content.length) {
            throw new ProtocolException("there is no content " + request.content() + " at " + request.offset());
        }
        int offset = (int) request.offset();
        int length = Math.min(content.length - offset, Limits.CONTENT_PIECE);
        byte[] piece = new byte[length];
        System.arraycopy(content, offset, piece, 0, length);
        return new Message.Content(request.content(), offset, content.length, piece);
    }

    /** Ends the connection where a deadline is missed. */
    public void check(long now) {
        long limit = server.timing().authenticationMillis() * 1_000_000L;
        if (!isKnown && now - opened > limit) {
            close("did not prove within " + limit / 1_000_000L + " ms who it is");
        } else if (channel != null) {
            channel.check(now);
        }
    }

    public void refuse(String reason, boolean again) {
        if (channel != null) {
            channel.sayLast(new Message.Refuse(reason, again));
        }
        tell(this + " refused: " + reason);
    }

    /** Logs a line; seldom per address while the connection is not authenticated. */
    public void tell(String line) {
        if (isKnown) {
            server.log().say(line);
        } else {
            server.log().seldom(address(), line);
        }
    }

    public void send(Message message) {
        channel.send(message);
    }

    public void sayLast(Message message) {
        MessageChannel mine = channel;
        if (mine == null) {
            close("");
        } else {
            mine.sayLast(message);
        }
    }

    void close(String reason) {
        MessageChannel mine = channel;
        if (mine != null) {
            mine.close(reason);
            return;
        }
        closedBecause = closedBecause.isEmpty() ? reason : closedBecause;
        try {
            plain.close();
        } catch (IOException e) {
            tell(this + ": " + e.getMessage());
        }
    }

    /** The event that lets the coordinator know the worker, which has joined from now on. */
    public Event.Joined joined() {
        isJoined = true;
        double weight = server.weight(hello.name(), host());
        return new Event.Joined(
                id,
                ContentHash.of(ready.process()),
                Origin.Peer.of(ready.machine()),
                isUnproven(hello),
                toString(),
                hello.threads(),
                weight);
    }

    public long id() {
        return id;
    }

    /** The worker has proved that it knows the token. */
    void known() {
        isKnown = true;
    }

    public boolean isKnown() {
        return isKnown;
    }

    public boolean isJoined() {
        return isJoined;
    }

    /** The key by which limits per address count this connection. */
    String address() {
        return Strangers.addressOf(plain.getInetAddress());
    }

    private String host() {
        return plain.getInetAddress().getHostAddress();
    }

    /** A name for logs, without the names that unauthenticated clients claim. */
    @Override
    public String toString() {
        Message.Hello h = isKnown ? hello : null;
        return h == null ? host() : Plain.line(h.name(), LONGEST_NAME) + " (" + host() + ")";
    }
}
