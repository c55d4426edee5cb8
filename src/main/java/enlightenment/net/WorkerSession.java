package enlightenment.net;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.security.SecureRandom;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import javax.net.ssl.SSLSocket;

/** One connection of a worker, from its first byte to its last. */
final class WorkerSession {
    private static final int CONNECT_MILLIS = 10_000;
    private static final long TICK_MILLIS = 100;
    private static final SecureRandom RANDOM = new SecureRandom();

    /** The link of the session that is on: finished tiles go there, whichever session began them. */
    private static final class Current extends AtomicReference<WorkerSession> {
        private static final long serialVersionUID = 1L;
    }

    private final Place place;
    private final WorkerOptions options;
    private final WorkerJobs jobs;
    private final BooleanSupplier cancelled;
    private volatile MessageChannel link;
    private volatile RenderPool pool;
    private volatile boolean wasWelcome;
    private volatile boolean isOver;
    private volatile long opened;
    private volatile Socket socket;
    private ContentHash job;
    private int heartbeatMillis = Timing.USUAL.heartbeatMillis();
    private volatile int silenceMillis;

    WorkerSession(Place place, WorkerOptions options, WorkerJobs jobs, BooleanSupplier cancelled) {
        this.place = place;
        this.options = options;
        this.jobs = jobs;
        this.cancelled = cancelled;
    }

    /** Where the server is and how it is spoken to; {@code tls} is null for none, {@code process} is its secret. */
    record Place(String host, int port, byte[] token, Tls tls, byte[] process, AtomicReference<WorkerSession> current) {
        Place(String host, int port, byte[] token, Tls tls, byte[] process) {
            this(host, port, token, tls, process, new Current());
        }
    }

    /** How a session ended: {@code isFinal} if it makes no sense to try again. */
    record End(boolean isFinal, boolean isDone, String reason) {}

    /** Whether the server let us in. */
    boolean wasWelcome() {
        return wasWelcome;
    }

    End run() {
        try (Socket plain = new Socket()) {
            socket = plain;
            opened = System.nanoTime();
            Thread ticker = new Thread(this::tickAll, "heartbeat");
            ticker.setDaemon(true);
            ticker.start();
            plain.connect(new InetSocketAddress(place.host(), place.port()), CONNECT_MILLIS);
            plain.setTcpNoDelay(true);
            return talk(plain);
        } catch (IOException e) {
            MessageChannel mine = link;
            String reason = mine == null || mine.reason().isEmpty() ? describe(e) : "the server " + mine.reason();
            return new End(jobs.failure() != null || e instanceof Tls.UntrustedException, false, reason);
        } finally {
            isOver = true;
            place.current().compareAndSet(this, null);
            if (link != null) {
                link.close();
            }
            if (pool != null) {
                pool.disconnected();
            }
        }
    }

    private String describe(IOException e) {
        Throwable failure = jobs.failure();
        String said = e.getMessage() == null ? e.getClass().getSimpleName() : e.getMessage();
        return failure == null ? said : "rendering failed here: " + failure;
    }

    private End talk(Socket plain) throws IOException {
        ContentHash certificate = Tls.noCertificate();
        Socket over = plain;
        if (place.tls() != null) {
            SSLSocket secured = place.tls().over(plain, place.host());
            certificate = Tls.shown(secured);
            over = secured;
        }
        MessageChannel on = new MessageChannel(plain, over, options.timing, "worker").begin();
        link = on;
        byte[] nonce = new byte[Handshake.NONCE_BYTES];
        RANDOM.nextBytes(nonce);
        on.send(hello(nonce));
        Message answer = on.receive();
        if (answer instanceof Message.Challenge challenge && challenge.protocol() == Message.PROTOCOL) {
            byte[] proof = Handshake.proof(Handshake.Side.WORKER, place.token(), nonce, challenge.nonce(), certificate);
            on.send(new Message.Proof(proof));
            answer = on.receive();
            if (answer instanceof Message.Welcome welcome) {
                byte[] expected =
                        Handshake.proof(Handshake.Side.SERVER, place.token(), nonce, challenge.nonce(), certificate);
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

    /** Whoever has not proved to be our server decides nothing: it may be our server later, and somebody else now. */
    private End unproven(String what) {
        return new End(
                false,
                false,
                "who answers at " + place.host() + ":" + place.port() + ", not proved to be the server, " + what);
    }

    private Message.Hello hello(byte[] nonce) {
        return new Message.Hello(
                Message.MAGIC,
                Message.PROTOCOL,
                Message.PROTOCOL,
                options.build,
                Machine.name(),
                options.threads,
                Canary.hash(),
                nonce);
    }

    private static End end(Message last) {
        if (last instanceof Message.Refuse refusal) {
            return new End(!refusal.again(), false, refusal.reason());
        }
        if (last instanceof Message.Bye bye) {
            return new End(true, true, bye.reason());
        }
        return new End(
                false,
                false,
                last == null ? "the server closed the connection" : "the server says what makes no sense now");
    }

    private End work(MessageChannel on, Message.Welcome welcome) throws IOException {
        on.trust();
        wasWelcome = true;
        heartbeatMillis = welcome.heartbeatMillis();
        silenceMillis = welcome.silenceMillis();
        Message first = on.receive();
        if (!(first instanceof Message.Job wanted)) {
            return end(first);
        }
        End early = new WorkerContents(on, jobs).fetch(wanted);
        if (early != null) {
            return early;
        }
        job = wanted.job();
        RenderPool mine;
        try {
            mine = jobs.pool(wanted, this::flush);
        } catch (IOException e) {
            on.sayLast(new Message.Bye(e.getMessage()));
            return new End(true, false, e.getMessage());
        }
        on.send(new Message.Ready(job, place.process(), Handshake.hmac(options.machine, job.toBytes())));
        pool = mine;
        place.current().set(this);
        flush();
        options.log.accept("working for " + place.host() + ":" + place.port());
        while (true) {
            Message message = on.receive();
            if (!hear(message)) {
                return end(message);
            }
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
            pool.acknowledged(m.tile());
            flush();
        } else {
            return message instanceof Message.Alive;
        }
        return true;
    }

    /** Sends what is finished, over the session that is on. */
    private void flush() {
        WorkerSession now = place.current().get();
        if (now == null || now.pool == null) {
            return;
        }
        for (WorkerCore.Outgoing tile : now.pool.outgoing()) {
            byte[] bytes = tile.data().bytes();
            now.link.send(new Message.Result(tile.lease(), now.job, tile.tile(), bytes));
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
                link.send(new Message.Heartbeat(pool.leases()));
            }
        }
    }

    private void tick(long now) {
        MessageChannel on = link;
        if (cancelled.getAsBoolean() || jobs.failure() != null) {
            if (on == null || on.isLastSaid()) {
                closeSocket();
            } else {
                on.sayLast(new Message.Bye(jobs.failure() == null ? "stopped" : "failed: " + jobs.failure()));
            }
        }
        if (!wasWelcome && now - opened > options.timing.authenticationMillis() * 1_000_000L) {
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
            options.log.accept("while closing: " + e.getMessage());
        }
    }
}
