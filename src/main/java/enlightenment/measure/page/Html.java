package enlightenment.measure.page;

import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.List;

/** Builder of a page in HTML, which escapes all text. */
final class Html {
    private final StringBuilder text = new StringBuilder();

    Html() {}

    /** Adds markup as it is. */
    Html raw(String markup) {
        text.append(markup);
        return this;
    }

    /** Adds an element with a text; {@code tag} may have attributes. */
    Html element(String tag, String content) {
        int space = tag.indexOf(' ');
        String name = space < 0 ? tag : tag.substring(0, space);
        text.append('<').append(tag).append('>').append(escaped(content));
        text.append("</").append(name).append(">\n");
        return this;
    }

    /** Adds a table. */
    Html table(List<String> heads, List<List<String>> rows) {
        text.append("<div class=\"wide\"><table>\n<tr>");
        heads.forEach(h -> text.append("<th>").append(escaped(h)).append("</th>"));
        text.append("</tr>\n");
        for (List<String> row : rows) {
            text.append("<tr>");
            row.forEach(c -> text.append("<td>").append(escaped(c)).append("</td>"));
            text.append("</tr>\n");
        }
        text.append("</table></div>\n");
        return this;
    }

    /** Adds a picture as a figure; its PNG bytes become part of the page. */
    Html picture(Image image, String description, String caption) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ImageFiles.toPng(image, out, ImageFiles.PngOptions.DEFAULT);
        return figure("image/png", out.toByteArray(), description, caption);
    }

    /** Adds an SVG drawing as a figure; it becomes part of the page. */
    Html drawing(String svg, String description) {
        return figure("image/svg+xml", svg.getBytes(StandardCharsets.UTF_8), description, "");
    }

    private Html figure(String type, byte[] data, String description, String caption) {
        text.append("<figure><img src=\"data:").append(type).append(";base64,");
        text.append(Base64.getEncoder().encodeToString(data))
                .append("\" alt=\"")
                .append(escaped(description));
        text.append("\">");
        if (!caption.isEmpty()) {
            element("figcaption", caption);
        }
        text.append("</figure>\n");
        return this;
    }

    static String escaped(String s) {
        return s.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace("\"", "&quot;");
    }

    @Override
    public String toString() {
        return text.toString();
    }
}
