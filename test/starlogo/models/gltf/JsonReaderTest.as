package starlogo.models.gltf
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertTrue;
    import starlogo.models.files.FileBudget;
    import starlogo.steps.finish;
    import support.Failures;

    public class JsonReaderTest
    {
        [Test]
        public function readsEachKindOfValue():void
        {
            var root:Object = read(" {\"a\" :[1,-2.5e-1,\n[],{ } , [[3]]],\t\"b\":true,\"c\":false,\"d\":null,\"e\":\"\",\"\":\"f\"}\r\n");
            assertEquals("1,-0.25", root.a.slice(0, 2).join());
            assertEquals(0, root.a[2].length);
            assertFalse(root.a[3] is Array);
            assertEquals(3, root.a[4][0][0]);
            assertTrue(root.b);
            assertFalse(root.c);
            assertNull(root.d);
            assertTrue(root.d !== undefined);
            assertEquals("", root.e);
            assertEquals("f", root[""]);
            assertEquals(7, read("7"));
            assertEquals("of two equal names the last one counts", 2, read("{\"a\":1,\"a\":2}").a);
            assertTrue(1 / read("-0") < 0);
            assertEquals(4294967311, read("4294967311"));
        }

        [Test]
        public function readsStrings():void
        {
            assertEquals("a\"\\/\b\f\n\r\t\u00E9\uD83D\uDE00", read("\"a\\\"\\\\\\/\\b\\f\\n\\r\\t\\u00e9\\uD83D\\uDE00\""));
            assertEquals("\\\\n\\", read("\"\\\\\\\\n\\\\\""));
            assertEquals("\\u0041", read("\"\\\\u0041\""));
            assertEquals("{[,:", read("\"{[,:\""));
            // what follows has the properties that every object has
            assertFalse(read("{\"__proto__\":{\"a\":1}}").a === 1);
        }

        [Test]
        public function saysWhereItIsWrong():void
        {
            var cases:Array = [["", 0, "cut off"], ["[", 1, "cut off"], ["[1", 2, "cut off"], ["{\"a\":", 5, "cut off"],
                    ["[\"a\\\"]", 2, "has no end"], ["]", 1, "unexpected \"]\""], ["[]]", 3, "unexpected \"]\""], ["[}", 2, "unexpected \"}\""],
                    ["{]", 2, "unexpected \"]\""], ["{\"a\":1]", 7, "unexpected \"]\""], ["[1,]", 4, "unexpected \"]\""],
                    ["{\"a\":1,}", 8, "unexpected \"}\""], ["[,1]", 2, "unexpected \",\""], ["[1 2]", 4, "unexpected \"2\""],
                    ["{\"a\" 1}", 6, "unexpected \"1\""], ["{\"a\"}", 5, "unexpected \"}\""], ["{1:2}", 2, "unexpected \"1\""],
                    ["{\"a\":}", 6, "unexpected \"}\""], ["[\"a\":1]", 5, "unexpected \":\""], ["1 2", 3, "unexpected \"2\""],
                    ["{}x", 3, "unexpected \"x\""], ["{,}", 2, "unexpected \",\""], ["[\"a\" \"b\"]", 6, "unexpected"], ["[01]", 2, "no number"],
                    ["[+1]", 2, "no number"], ["[1.]", 2, "no number"], ["[.5]", 2, "no number"], ["[1e]", 2, "no number"],
                    ["[0x1]", 2, "no number"], ["[NaN]", 2, "no number"], ["[True]", 2, "no number"], ["[toString]", 2, "no number"],
                    ["['a']", 2, "no number"], ["[\u00A01]", 2, "no number"], ["[-]", 2, "no number"], ["/**/1", 1, "no number"],
                    ["[\"\\q\"]", 2, "wrong character or escape"], ["[\"\\u00g0\"]", 2, "wrong character or escape"],
                    ["[\"a\nb\"]", 2, "wrong character or escape"]];
            for each (var each:Array in cases)
            {
                Failures.assertFails("character " + each[1], each[2], read, each[0]);
            }
        }

        [Test]
        public function namesTheValueThatIsTooMany():void
        {
            var limits:FileBudget = new FileBudget("a", 0);
            limits.spendElements(49999, "");
            Failures.assertFails("character 8", "more than 50000 elements", finish, new JsonReader("[0,0,0,0,0,0,0]", limits));
        }

        private static function read(text:String):*
        {
            var reader:JsonReader = new JsonReader(text, new FileBudget("a", text.length));
            finish(reader);
            return reader.root;
        }
    }
}
