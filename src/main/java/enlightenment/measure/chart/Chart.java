package enlightenment.measure.chart;

import enlightenment.image.Image;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.StringWriter;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.apache.batik.svggen.SVGGeneratorContext;
import org.apache.batik.svggen.SVGGraphics2D;
import org.knowm.xchart.XYChart;
import org.w3c.dom.Document;

/** A finished chart, as pixels or as SVG. */
public final class Chart {
    private static final int PIXELS_PER_UNIT = 2;
    private static final float WHITE = 255;
    private static final int DECIMALS = 2;

    private final String name;
    private final String description;
    private final XYChart chart;

    Chart(String name, String description, XYChart chart) {
        this.name = name;
        this.description = description;
        this.chart = chart;
    }

    /** The name of the chart's file, without an extension. */
    public String name() {
        return name;
    }

    /** A text alternative of the chart. */
    public String description() {
        return description;
    }

    /** The chart as pixels, two for each unit along each side, for screens of high resolution. */
    public Image image() {
        int width = PIXELS_PER_UNIT * ChartTheme.WIDTH;
        int height = PIXELS_PER_UNIT * ChartTheme.HEIGHT;
        BufferedImage canvas = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = canvas.createGraphics();
        g.scale(PIXELS_PER_UNIT, PIXELS_PER_UNIT);
        chart.paint(g, ChartTheme.WIDTH, ChartTheme.HEIGHT);
        g.dispose();
        float[] rgb = new float[3 * width * height];
        int i = 0;
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                Color c = new Color(canvas.getRGB(x, y));
                rgb[i++] = c.getRed() / WHITE;
                rgb[i++] = c.getGreen() / WHITE;
                rgb[i++] = c.getBlue() / WHITE;
            }
        }
        return new Image(width, height, rgb);
    }

    /** The chart as SVG. XChart draws letters as shapes, so that the look does not depend on fonts. */
    public String svg() throws IOException {
        Document document;
        try {
            document = DocumentBuilderFactory.newInstance()
                    .newDocumentBuilder()
                    .getDOMImplementation()
                    .createDocument("http://www.w3.org/2000/svg", "svg", null);
        } catch (ParserConfigurationException e) {
            throw new IOException("this Java makes no XML documents: " + e.getMessage(), e);
        }
        SVGGeneratorContext context = SVGGeneratorContext.createDefault(document);
        context.setPrecision(DECIMALS);
        context.setComment(null);
        SVGGraphics2D g = new SVGGraphics2D(context, false);
        g.setSVGCanvasSize(new Dimension(ChartTheme.WIDTH, ChartTheme.HEIGHT));
        chart.paint(g, ChartTheme.WIDTH, ChartTheme.HEIGHT);
        StringWriter text = new StringWriter();
        g.stream(text, true);
        return text.toString();
    }
}
