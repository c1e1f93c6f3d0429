package starlogo.models.collada
{
    import flash.utils.getTimer;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertTrue;
    import starlogo.models.ModelError;
    import starlogo.models.files.FileBudget;
    import starlogo.models.text.TextWords;
    import starlogo.steps.finish;
    import support.assertThrows;

    public class XmlReaderTest
    {
        [Test]
        public function readsElementsAttributesAndTexts():void
        {
            var root:ColladaElement = read("\uFEFF<?xml version='1.0'?><!DOCTYPE a [<!ENTITY x \"y\">]>\n<a b=\"1\" c = '>\"2'>one<d/>two<d id=\"e\"> </d ></a>\n<!-- end -->");
            assertEquals("a", root.name);
            assertEquals("1", root.attribute("b"));
            assertEquals(">\"2", root.attribute("c"));
            assertEquals("", root.attribute("toString"));
            assertEquals("one,two", TextWords.of(root.text).join());
            assertEquals(2, root.childrenNamed("d").length);
            assertEquals("d#e", String(root.children[1]));
            assertEquals("d[1]", String(read("<a><d/><d/></a>").children[0]));
        }

        [Test]
        public function namesHaveNoPrefix():void
        {
            var root:ColladaElement = read("<c:a b='1' x:b='2' x:e='3'><c:d/></c:a>");
            assertEquals("a", root.name);
            assertEquals("1", root.attribute("b"));
            assertEquals("", root.attribute("e"));
            assertEquals("d", root.children[0].name);
        }

        [Test]
        public function attributesHaveNoBlanksAroundThem():void
        {
            assertEquals("b  c", read("<a b=' \t\r\nb  c\n '/>").attribute("b"));
            assertEquals("", read("<a b=' \n '/>").attribute("b"));
            // the time must not be that of the square of the length
            var blanks:String = new Array(300000).join(" ");
            var start:int = getTimer();
            assertEquals("b" + blanks + "c", read("<a b='" + blanks + "b" + blanks + "c'/>").attribute("b"));
            assertTrue(getTimer() - start < 2000);
        }

        [Test]
        public function knowsItsOwnEntitiesAndNoOthers():void
        {
            var root:ColladaElement = read("<a b=' &lt;&#65;&#x42;&gt; '>&amp;&quot;&apos;&other;&LT;</a>");
            assertEquals("<AB>", root.attribute("b"));
            assertEquals("&\"'&other;&LT;", root.texts.join(""));
            assertEquals("no characters", "&#0;&#x110000;&#99999999999;", read("<a>&#0;&#x110000;&#99999999999;</a>").text);
            assertEquals("\uD83D\uDE00 \uFFFD \uDBFF\uDFFF", read("<a>&#x1F600; &#xFFFD; &#1114111;</a>").text);
        }

        [Test]
        public function passesOverComments():void
        {
            assertEquals("1,2,<b>,3", TextWords.of(read("<a>1<!-- <b> -- > -->2<![CDATA[ <b> ]]>3<?d <e> ?></a>").text).join());
        }

        [Test]
        public function thereMayBeNoElement():void
        {
            assertNull(read(""));
            assertNull(read("text, <!-- and a comment -->"));
        }

        [Test]
        public function refusesWhatIsNotWellFormed():void
        {
            for each (var source:String in ["<a", "<a>", "<a></b>", "</a>", "<a/><b/>", "<a b></a>", "<a b=1/>", "<a b='1/>", "<a b='1'c/>", "<a 'b'/>", "<a><!-- ></a>", "<a><!--></a>",
                        "<a><![CDATA[</a>", "<a><b></a></b>", "< a/>", "<?a", "<a b='1' c></a>", "<a b='1'c='2'/>"])
            {
                assertThrows(ModelError, /not well-formed/, read, source);
            }
        }

        private static function read(source:String):ColladaElement
        {
            var work:XmlReader = new XmlReader(source, new FileBudget("a", source.length));
            finish(work);
            return work.root;
        }
    }
}
