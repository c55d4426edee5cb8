package enlightenment.net.worker;

import enlightenment.file.ContentHash;
import enlightenment.net.protocol.Limits;
import enlightenment.net.protocol.Message;
import enlightenment.net.protocol.MessageChannel;
import enlightenment.net.protocol.ProtocolException;
import java.io.ByteArrayOutputStream;
import java.io.IOException;

/** Fetches what a job needs, by hash; nothing is kept whose hash is another. */
final class WorkerContents {
    private final MessageChannel channel;
    private final WorkerJobs jobs;
    private final Runnable kept;

    /** Bytes of the job that are here, kept or on their way. */
    private long fetched;

    /** @param kept called whenever a content is here whose hash is right */
    WorkerContents(MessageChannel channel, WorkerJobs jobs, Runnable kept) {
        this.channel = channel;
        this.jobs = jobs;
        this.kept = kept;
    }

    /** Null when all is there; else how the session ends. */
    SessionEnd fetch(Message.Job job) throws IOException {
        if (!job.contents().get(0).equals(job.job())) {
            throw new ProtocolException("the job's hash is not that of its document");
        }
        fetched = jobs.retain(job.contents());
        for (ContentHash hash : job.contents()) {
            if (!jobs.has(hash)) {
                SessionEnd end = fetch(hash);
                if (end != null) {
                    return end;
                }
            }
        }
        return null;
    }

    private SessionEnd fetch(ContentHash hash) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        long total;
        do {
            channel.send(new Message.ContentRequest(hash, bytes.size()));
            Message message = channel.receive();
            if (message instanceof Message.Refuse refusal) {
                return new SessionEnd(!refusal.again(), false, refusal.reason());
            }
            if (message instanceof Message.Bye bye) {
                return new SessionEnd(true, true, bye.reason());
            }
            if (!(message instanceof Message.Content piece)
                    || !piece.content().equals(hash)
                    || piece.offset() != bytes.size()
                    || (piece.piece().length == 0 && piece.total() > bytes.size())) {
                throw new ProtocolException("another content than was asked for");
            }
            total = piece.total();
            fetched += piece.piece().length;
            if (fetched > Limits.JOB || total > Limits.JOB) {
                return new SessionEnd(true, false, "the job has more than " + Limits.JOB + " bytes");
            }
            bytes.write(piece.piece());
        } while (bytes.size() < total);
        byte[] content = bytes.toByteArray();
        if (!ContentHash.of(content).equals(hash)) {
            throw new ProtocolException("content " + hash + " came with other bytes");
        }
        jobs.keep(hash, content);
        kept.run();
        return null;
    }
}
