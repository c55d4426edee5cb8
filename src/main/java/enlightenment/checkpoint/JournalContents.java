package enlightenment.checkpoint;

import enlightenment.job.RenderIdentity;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.util.Optional;

/** Checks that a file is a journal, and of which render. */
final class JournalContents {
    private JournalContents() {}

    /**
     * The header of a journal; empty for a file of which not even a header was written.
     *
     * @param found what it begins with, as far as headers reach
     * @throws JournalException if it is something else
     */
    static Optional<JournalFormat.Header> header(Path path, byte[] found) throws IOException {
        JournalFormat.Header first = JournalFormat.Header.decode(found, 0);
        JournalFormat.Header header =
                first != null ? first : JournalFormat.Header.decode(found, JournalFormat.HEADER_BYTES);
        // A process may have died while it wrote the first one.
        if (header == null && !JournalFormat.Header.beginsLike(found)) {
            throw new JournalException(
                    JournalFormat.isOtherVersion(found)
                            ? path
                                    + " is a checkpoint of another version of Enlightenment, which cannot go on here;"
                                    + " it is left as it is"
                            : path + " is not a checkpoint; it is left as it is");
        }
        return Optional.ofNullable(header);
    }

    /**
     * Whether the journal is of another render and has no results.
     *
     * @throws JournalException if it holds something of another render; the message says what differs
     */
    static boolean isOfOther(
            Path path, FileChannel file, JournalFormat.Header header, JournalFormat.Header own, RenderIdentity render)
            throws IOException {
        String difference = header.difference(own);
        if (difference.isEmpty()) {
            return false;
        }
        JournalScan scan = new JournalScan(file, header);
        boolean hasResults = false;
        for (byte[] body = scan.next(); body != null; body = scan.next()) {
            byte kind = JournalEntry.kind(body);
            hasResults |= kind == JournalRecord.KEPT;
            // The same in more words; an older one may be of a render that this file was of before.
            if (kind == JournalRecord.ABOUT && JournalEntry.of(body).record() instanceof JournalRecord.About about) {
                difference = new RenderIdentity(header.scene(), about.settings(), about.build())
                        .difference(render)
                        .orElse(difference);
            }
        }
        if (hasResults) {
            throw new JournalException(path + " is the checkpoint of another render, which differs in " + difference
                    + "; it is left as it is");
        }
        return true;
    }
}
