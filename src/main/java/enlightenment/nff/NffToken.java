package enlightenment.nff;

/**
 * A word of an NFF file.
 *
 * @param text the word, or "" at the end of the file
 * @param line its line, counted from 1
 * @param column its first character, counted from 1
 */
record NffToken(String text, int line, int column) {

    boolean isEnd() {
        return text.isEmpty();
    }

    /** Whether it can only be meant as a number. */
    boolean startsLikeNumber() {
        char c = isEnd() ? ' ' : text.charAt(0);
        return c >= '0' && c <= '9' || c == '+' || c == '-' || c == '.';
    }

    /** For messages. */
    String quoted() {
        return isEnd() ? "the end of the file" : "'" + text + "'";
    }
}
