package enlightenment.net.worker;

import enlightenment.file.ContentHash;
import enlightenment.file.FileFailure;
import enlightenment.net.job.Canary;
import enlightenment.net.protocol.Message;
import enlightenment.net.protocol.MessageChannel;
import enlightenment.net.protocol.ProtocolException;
import enlightenment.net.protocol.Timing;
import enlightenment.net.schedule.WorkerCore;
import enlightenment.net.secure.Handshake;
import enlightenment.net.secure.Tls;
import java.io.IOException;
import java.math.BigDecimal;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.security.SecureRandom;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import javax.net.ssl.SSLException;
import javax.net.ssl.SSLSocket;

/** One connection of a worker, from its first byte to its last. */
public final class WorkerSession {
    private static final int CONNECT_TIMEOUT_MILLIS = 10_000;
    private static final long TICK_MILLIS = 100;
    private static final SecureRandom RANDOM = new SecureRandom();

    private final ServerAddress server;
    private final Identity identity;
    private final Timing timing;
    private final WorkerJobs jobs;
    private final AtomicReference<WorkerSession> current;
    private final Consumer<String> log;
    private final BooleanSupplier cancelled;
    private volatile MessageChannel channel;
    private volatile RenderPool pool;
    private volatile boolean wasWelcome;
    private volatile boolean hasProgress;
    private volatile long usefulNanos;
    private volatile boolean isOver;

    /** Whether somebody took the connection, then said something; and whether the proof was waited for in vain. */
    private volatile boolean isConnected;

    private volatile boolean isAnswered;
    private volatile boolean isTooLate;
    private volatile long opened;
    private volatile Socket socket;
    private ContentHash job;
    private int heartbeatMillis = Timing.DEFAULT.heartbeatMillis();
    private volatile int silenceMillis;

    /** Where the server is and how it is spoken to; {@code tls} is null for none. */
    public record ServerAddress(String host, int port, byte[] token, Tls tls) {}

    /**
     * What a worker says of itself.
     *
     * @param version of this program
     * @param threads number of tiles that it renders at once
     * @param process a secret of this process, the same over all its connections
     * @param machine a secret of this machine, see {@link MachineIdentity#secret}
     */
    public record Identity(String version, int threads, byte[] process, byte[] machine) {}

    /**
     * A session that has not begun.
     *
     * @param jobs what the worker has kept from earlier sessions
     * @param current the session that is on, shared by all sessions of a worker: finished tiles go there, whichever session
     *     began them
     * @param cancelled asked several times a second; once true, the session says good-bye
     */
    public WorkerSession(
            ServerAddress server,
            Identity identity,
            Timing timing,
            WorkerJobs jobs,
            AtomicReference<WorkerSession> current,
            Consumer<String> log,
            BooleanSupplier cancelled) {
        this.server = server;
        this.identity = identity;
        this.timing = timing;
        this.jobs = jobs;
        this.current = current;
        this.log = log;
        this.cancelled = cancelled;
    }

    /** Whether the server has taken a tile. */
    public boolean hasProgress() {
        return hasProgress;
    }

    /** From the beginning until the last content or message that a server of this job sends, in nanoseconds; 0 if none came. */
    public long usefulNanos() {
        return usefulNanos;
    }

    private void useful() {
        usefulNanos = System.nanoTime() - opened;
    }

    /** Whether the server let us in. */
    public boolean wasWelcome() {
        return wasWelcome;
    }

    public SessionEnd run() {
        try (Socket plain = new Socket()) {
            socket = plain;
            opened = System.nanoTime();
            Thread ticker = new Thread(this::tickAll, "heartbeat");
            ticker.setDaemon(true);
            ticker.start();
            plain.connect(new InetSocketAddress(server.host(), server.port()), CONNECT_TIMEOUT_MILLIS);
            isConnected = true;
            plain.setTcpNoDelay(true);
            try {
                return talk(plain);
            } catch (IOException e) {
                // Told before the socket is closed, which would end the channel's writer for a reason of its own.
                return broken(e);
            }
        } catch (IOException e) {
            return broken(e);
        } finally {
            isOver = true;
            current.compareAndSet(this, null);
            if (channel != null) {
                channel.close();
            }
            if (pool != null) {
                pool.disconnected();
            }
        }
    }

    private SessionEnd broken(IOException e) {
        Throwable failure = jobs.failure();
        MessageChannel mine = channel;
        String closed = mine == null ? "" : mine.reason();
        if (failure != null && closed.isEmpty()) {
            return new SessionEnd(true, false, "rendering failed here: " + FileFailure.told(failure));
        }
        if (e instanceof ProtocolException p && p.isAboutTls()) {
            return new SessionEnd(false, false, "the server speaks TLS: a worker of it needs --pin or --tls-ca");
        }
        boolean isUntrusted = e instanceof Tls.UntrustedException;
        if (isConnected && !wasWelcome && !isUntrusted && failure == null) {
            // What is no message comes before the channel's end, which it may bring about.
            return unproven(closed.isEmpty() || e instanceof ProtocolException ? stranger(e) : closed);
        }
        String reason = closed.isEmpty() ? FileFailure.reason(e) : "the server " + closed;
        return new SessionEnd(failure != null || isUntrusted, false, reason);
    }

    /** What somebody does who answers and has not proved to be the server. */
    private String stranger(IOException e) {
        if (isTooLate) {
            return String.format(
                    Locale.ROOT,
                    "says %s within %s s",
                    isAnswered ? "no more" : "nothing",
                    BigDecimal.valueOf(timing.authenticationMillis(), 3)
                            .stripTrailingZeros()
                            .toPlainString());
        }
        return (e instanceof ProtocolException || e instanceof SSLException ? "speaks another protocol: " : "")
                + FileFailure.reason(e);
    }

    private SessionEnd talk(Socket plain) throws IOException {
        ContentHash certificate = Tls.noCertificate();
        Socket over = plain;
        if (server.tls() != null) {
            SSLSocket secured = server.tls().over(plain, server.host());
            certificate = Tls.shown(secured);
            over = secured;
        }
        MessageChannel on = new MessageChannel(plain, over, timing, "worker").begin();
        channel = on;
        byte[] nonce = new byte[Handshake.NONCE_BYTES];
        RANDOM.nextBytes(nonce);
        on.send(hello(nonce));
        Message answer = on.receive();
        isAnswered = true;
        if (answer instanceof Message.Challenge challenge && challenge.protocol() == Message.PROTOCOL) {
            byte[] proof =
                    Handshake.proof(Handshake.Side.WORKER, server.token(), nonce, challenge.nonce(), certificate);
            on.send(new Message.Proof(proof));
            answer = on.receive();
            if (answer instanceof Message.Welcome welcome) {
                byte[] expected =
                        Handshake.proof(Handshake.Side.SERVER, server.token(), nonce, challenge.nonce(), certificate);
                return Handshake.same(expected, welcome.mac())
                        ? work(on, welcome)
                        : unproven("does not know the token");
            }
        }
        return unproven(
                answer instanceof Message.Refuse refusal
                        ? "says: " + refusal.reason()
                        : answer instanceof Message.Bye bye
                                ? "says: " + bye.reason()
                                : answer == null ? "closes the connection" : "says what makes no sense now");
    }

    /** A peer that has not proved to be our server decides nothing: the address may be our server's later, and another's now. */
    private SessionEnd unproven(String what) {
        return new SessionEnd(
                false,
                false,
                "who answers at " + server.host() + ":" + server.port() + ", not proved to be the server, " + what);
    }

    private Message.Hello hello(byte[] nonce) {
        return new Message.Hello(
                Message.MAGIC,
                Message.PROTOCOL,
                Message.PROTOCOL,
                identity.version(),
                MachineIdentity.workerName(),
                identity.threads(),
                Canary.hash(),
                nonce);
    }

    private static SessionEnd end(Message last) {
        if (last instanceof Message.Refuse refusal) {
            return new SessionEnd(!refusal.again(), false, refusal.reason());
        }
        if (last instanceof Message.Bye bye) {
            return new SessionEnd(true, true, bye.reason());
        }
        return new SessionEnd(
                false,
                false,
                last == null ? "the server closed the connection" : "the server says what makes no sense now");
    }

    private SessionEnd work(MessageChannel on, Message.Welcome welcome) throws IOException {
        on.trust();
        wasWelcome = true;
        heartbeatMillis = welcome.heartbeatMillis();
        silenceMillis = welcome.silenceMillis();
        Message first = on.receive();
        if (!(first instanceof Message.Job wanted)) {
            return end(first);
        }
        SessionEnd early = new WorkerContents(on, jobs, this::useful).fetch(wanted);
        if (early != null) {
            return early;
        }
        job = wanted.job();
        RenderPool mine;
        try {
            mine = jobs.pool(wanted, this::flush);
        } catch (IOException e) {
            String reason = FileFailure.described(e);
            on.sayLast(new Message.Bye(reason));
            return new SessionEnd(true, false, reason);
        }
        on.send(new Message.Ready(job, identity.process(), Handshake.hmac(identity.machine(), job.toBytes())));
        pool = mine;
        current.set(this);
        flush();
        log.accept("working for " + server.host() + ":" + server.port());
        while (true) {
            Message message = on.receive();
            if (!hear(message)) {
                return end(message);
            }
            useful();
        }
    }

    /** False if it is the last message, or none that belongs here. */
    private boolean hear(Message message) {
        if (message instanceof Message.Grant m && m.job().equals(job)) {
            pool.granted(m.lease(), m.first(), m.last());
        } else if (message instanceof Message.Cancel m) {
            pool.cancelled(m.lease());
        } else if (message instanceof Message.Skip m) {
            pool.skipped(m.lease(), m.first(), m.last());
        } else if (message instanceof Message.Acknowledge m) {
            // One that the worker has none of is no sign of a server.
            hasProgress |= pool.acknowledged(m.tile());
            flush();
        } else {
            return message instanceof Message.Alive;
        }
        return true;
    }

    /** Sends what is finished, over the session that is on. */
    private void flush() {
        WorkerSession now = current.get();
        if (now == null || now.pool == null) {
            return;
        }
        for (WorkerCore.Outgoing tile : now.pool.outgoing()) {
            byte[] bytes = tile.data().bytes();
            now.channel.send(new Message.Result(tile.lease(), now.job, tile.tile(), bytes));
        }
    }

    private void tickAll() {
        long lastBeat = 0;
        while (!isOver) {
            try {
                Thread.sleep(Math.min(TICK_MILLIS, heartbeatMillis));
            } catch (InterruptedException e) {
                return;
            }
            long now = System.nanoTime();
            tick(now);
            if (pool != null && now - lastBeat >= heartbeatMillis * 1_000_000L) {
                lastBeat = now;
                channel.send(new Message.Heartbeat(pool.leases()));
            }
        }
    }

    private void tick(long now) {
        MessageChannel on = channel;
        if (cancelled.getAsBoolean() || jobs.failure() != null) {
            if (on == null || on.isLastSaid()) {
                closeSocket();
            } else {
                Throwable failure = jobs.failure();
                on.sayLast(new Message.Bye(failure == null ? "stopped" : "failed: " + FileFailure.told(failure)));
            }
        }
        if (!wasWelcome && now - opened > timing.authenticationMillis() * 1_000_000L) {
            isTooLate = isConnected;
            closeSocket();
        }
        if (on != null) {
            on.check(now);
            if (pool != null && now - on.heard() > silenceMillis * 1_000_000L) {
                on.close("is silent");
            }
        }
    }

    private void closeSocket() {
        try {
            socket.close();
        } catch (IOException e) {
            log.accept("while closing: " + e.getMessage());
        }
    }
}
