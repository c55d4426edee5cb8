package enlightenment.net.server;

import enlightenment.work.ThreadEnd;
import java.util.ArrayDeque;
import java.util.Queue;
import java.util.concurrent.TimeUnit;

/**
 * Runs the archives' work, in order, on a thread of its own. The caller of {@link #add} holds the server's lock and must not wait for a
 * database. The queue is bounded; the caller waits only while it is full. The thread is never interrupted, since files that it writes would
 * be closed.
 */
final class ArchiveThread implements AutoCloseable {
    private static final long TICK_NANOS = 200_000_000L;

    /** Work that waits has no more bytes than these, or is one piece. */
    private final long mostBytes;

    private final Runnable tick;
    private final Queue<Piece> waiting = new ArrayDeque<>();
    private final Thread thread = new Thread(this::work, "enlightenment-archives");
    private long bytes;
    private boolean isClosed;

    private record Piece(long bytes, Runnable work) {}

    /** @param tick done on the thread several times a second while there is nothing else to do */
    ArchiveThread(long mostBytes, Runnable tick) {
        this.mostBytes = mostBytes;
        this.tick = tick;
        thread.setDaemon(true);
        thread.start();
    }

    /**
     * Adds a piece of work; what comes after the end is not done.
     *
     * @param size of what it holds
     */
    synchronized void add(long size, Runnable work) {
        boolean wasInterrupted = false;
        while (!isClosed && bytes > 0 && bytes + size > mostBytes) {
            try {
                wait();
            } catch (InterruptedException e) {
                wasInterrupted = true;
            }
        }
        if (!isClosed) {
            waiting.add(new Piece(size, work));
            bytes += size;
            notifyAll();
        }
        if (wasInterrupted) {
            Thread.currentThread().interrupt();
        }
    }

    private void work() {
        try {
            long ticked = System.nanoTime();
            while (true) {
                Piece piece = next(ticked);
                if (piece != null) {
                    piece.work.run();
                    done(piece);
                } else if (isEnded()) {
                    return;
                }
                if (System.nanoTime() - ticked >= TICK_NANOS) {
                    tick.run();
                    ticked = System.nanoTime();
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } finally {
            end();
        }
    }

    /** Closes the queue: what waits is still done, if the thread lives; callers of {@link #add} wait no longer. */
    private synchronized void end() {
        isClosed = true;
        notifyAll();
    }

    /** The next piece, which still counts; null if there is none until it is time for a tick, or the end. */
    private synchronized Piece next(long ticked) throws InterruptedException {
        while (waiting.isEmpty() && !isClosed) {
            long left = ticked + TICK_NANOS - System.nanoTime();
            if (left <= 0) {
                return null;
            }
            TimeUnit.NANOSECONDS.timedWait(this, left);
        }
        return waiting.poll();
    }

    private synchronized void done(Piece piece) {
        bytes -= piece.bytes;
        notifyAll();
    }

    private synchronized boolean isEnded() {
        return isClosed && waiting.isEmpty();
    }

    /** Returns when all that was added is done, and nothing will be any more. */
    @Override
    public void close() {
        end();
        ThreadEnd.await(thread);
    }
}
