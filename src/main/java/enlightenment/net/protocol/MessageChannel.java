package enlightenment.net.protocol;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.ByteArrayInputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.SequenceInputStream;
import java.net.Socket;
import java.util.ArrayDeque;
import java.util.Deque;

/**
 * Messages over one connection. One thread receives; messages to be sent wait in a bounded queue for a thread of the channel's
 * own, which {@link #begin} starts. {@link #check}, called several times a second, ends the channel where a deadline is missed: closing the
 * plain socket ends every read and write, whatever TLS is about.
 */
public final class MessageChannel implements Closeable {
    private static final int BUFFER = 1 << 16;
    private static final long MILLI = 1_000_000L;

    /** How long a channel stays open for the other side to read the last message. */
    private static final long FAREWELL_TIMEOUT_NANOS = 2_000 * MILLI;

    private final Socket plain;
    private final Timing timing;
    private final InputStream in;
    private final OutputStream out;
    private final Deque<Message> queue = new ArrayDeque<>();
    private final Thread writer;
    private int limit = Limits.FRAME_BEFORE_AUTHENTICATION;
    private boolean isLastSaid;
    private boolean isClosed;
    private String reason = "";

    /** Begin of the frame that is being read or written, and of the farewell; 0 for none. */
    private volatile long readingSince;

    private volatile long writingSince;
    private volatile long farewellSince;
    private volatile long heard = System.nanoTime();

    /**
     * A channel over a connection.
     *
     * @param plain the socket itself
     * @param socket the same, or TLS over it
     */
    public MessageChannel(Socket plain, Socket socket, Timing timing, String name) throws IOException {
        this.plain = plain;
        this.timing = timing;
        in = new BufferedInputStream(socket.getInputStream(), BUFFER);
        out = new BufferedOutputStream(socket.getOutputStream(), BUFFER);
        writer = new Thread(this::writeAll, name + " writer");
        writer.setDaemon(true);
    }

    /** Starts the thread that sends; until then messages wait. A connection that sends nothing needs no thread. */
    public MessageChannel begin() {
        writer.start();
        return this;
    }

    /** Lets larger frames in: the other side has proved itself. */
    public void trust() {
        limit = Limits.FRAME;
    }

    /**
     * The next message; null if the other side has closed the connection.
     *
     * @throws IOException if the connection broke, was ended here ({@link #reason}), or brought what is no message
     */
    public Message receive() throws IOException {
        int first = in.read();
        if (first < 0) {
            return null;
        }
        readingSince = System.nanoTime() | 1;
        try {
            InputStream frame = new SequenceInputStream(new ByteArrayInputStream(new byte[] {(byte) first}), in);
            Message message = Frames.read(frame, limit).orElseThrow();
            heard = System.nanoTime();
            return message;
        } finally {
            readingSince = 0;
        }
    }

    /** Sends a message soon. Where too many wait already, the other side is too slow, and the channel ends. */
    public void send(Message message) {
        boolean full;
        synchronized (queue) {
            if (isClosed || isLastSaid) {
                return;
            }
            full = queue.size() >= Limits.QUEUED_MESSAGES;
            if (!full) {
                queue.addLast(message);
                queue.notifyAll();
            }
        }
        if (full) {
            close("does not read what it is sent");
        }
    }

    /** Waits until nothing waits to be sent, then sends; for what is large. */
    public void sendWhenFree(Message message) throws IOException {
        long deadline = System.nanoTime() + timing.writeMillis() * MILLI;
        synchronized (queue) {
            while (!isClosed && !queue.isEmpty() && deadline - System.nanoTime() > 0) {
                await(100);
            }
            if (!isClosed && !queue.isEmpty()) {
                throw new IOException("does not read what it is sent");
            }
        }
        send(message);
    }

    /** Sends a last message; what comes is not listened to any more, and the channel ends when the other side has closed it. */
    public void sayLast(Message message) {
        if (writer.getState() == Thread.State.NEW) {
            close("");
            return;
        }
        send(message);
        synchronized (queue) {
            isLastSaid = true;
            queue.notifyAll();
        }
        farewellSince = System.nanoTime() | 1;
    }

    public boolean isLastSaid() {
        synchronized (queue) {
            return isLastSaid;
        }
    }

    private void writeAll() {
        try {
            for (Message message = next(); message != null; message = next()) {
                writingSince = System.nanoTime() | 1;
                Frames.write(out, message, Limits.FRAME);
                if (isQueueEmpty()) {
                    out.flush();
                }
                writingSince = 0;
            }
            plain.shutdownOutput();
        } catch (IOException | RuntimeException e) {
            close("cannot be written to: " + e.getMessage());
        }
    }

    private boolean isQueueEmpty() {
        synchronized (queue) {
            return queue.isEmpty();
        }
    }

    private Message next() {
        synchronized (queue) {
            while (queue.isEmpty()) {
                if (isClosed || isLastSaid) {
                    return null;
                }
                await(1_000);
            }
            Message message = queue.removeFirst();
            queue.notifyAll();
            return message;
        }
    }

    private void await(long millis) {
        try {
            queue.wait(millis);
        } catch (InterruptedException e) {
            isClosed = true;
            Thread.currentThread().interrupt();
        }
    }

    /** Ends the channel if a deadline is missed. */
    public void check(long now) {
        if (isLate(readingSince, timing.frameMillis(), now)) {
            close("sends a message too slowly");
        } else if (isLate(writingSince, timing.writeMillis(), now)) {
            close("does not read what it is sent");
        } else if (isLate(heard, timing.idleMillis(), now)) {
            close("is idle");
        } else if (farewellSince != 0 && now - farewellSince > FAREWELL_TIMEOUT_NANOS) {
            close("");
        }
    }

    private static boolean isLate(long since, int millis, long now) {
        return since != 0 && now - since > millis * MILLI;
    }

    /** When the last message came, by {@link System#nanoTime}. */
    public long heard() {
        return heard;
    }

    /** Ends the channel at once, for this reason. */
    public void close(String why) {
        synchronized (queue) {
            if (!isClosed) {
                reason = why;
                isClosed = true;
            }
            queue.notifyAll();
        }
        try {
            plain.close();
        } catch (IOException e) {
            // It is closed for us in any case.
            return;
        }
    }

    @Override
    public void close() {
        close("");
    }

    /** Why the channel was ended here; empty if it was not. */
    public String reason() {
        synchronized (queue) {
            return reason;
        }
    }
}
