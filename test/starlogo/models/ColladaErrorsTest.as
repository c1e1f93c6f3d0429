package starlogo.models
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import support.Collada;
    import support.Failures;
    import support.create;

    public class ColladaErrorsTest
    {
        private static const POINTS:String = "0 0 0 1 0 0 1 1 0";
        private static const MESH:String = "library_geometries/geometry#a/mesh";
        private static const NODE:String = '<node id="n"><instance_geometry url="#a"/></node>';

        [Test]
        public function whatIsNoDocument():void
        {
            fails("", "not XML", "");
            fails("", "not XML", "hello");
            fails("", "not XML", "\u0089PNG\r\n\u001a\n");
            fails("line 1", "not well-formed XML, or cut off", "<COLLADA><a>");
            fails("line 4", "not well-formed XML, or cut off", "<COLLADA>\n<a>\r\n<b/>\r");
            fails("line 2", "not well-formed", "<svg>\n</COLLADA>\n");
            fails("svg", "root element is <svg>", "<svg/>");
            fails("", "no vertices", "<COLLADA/>");
            fails("", "no vertices", Collada.scene("", "<node/>"));
            fails("", "no vertices", Collada.document('<library_geometries><geometry id="a"><spline/></geometry></library_geometries>'));
        }

        [Test]
        public function brokenNumbers():void
        {
            mesh("/source#p/float_array#f", "\"nan\"", "0 0 0 1 nan 0 1 1 0", Collada.triangles("0 1 2"));
            mesh("/source#p/float_array#f", "\"1e999\"", "0 0 0 1 1e999 0 1 1 0", Collada.triangles("0 1 2"));
            mesh("/source#p/float_array#f", "\"1,2,3\"", "0 0 0 1 1,2,3 0 1 1 0", Collada.triangles("0 1 2"));
            replaced("/source#p/float_array#f", "its count is 1e9, but it has 9 values", 'count="9"', 'count="1e9"');
            replaced("/source#p/float_array#f", "whole number", 'count="9"', 'count="-9"');
            replaced("/source#p/float_array#f", "whole number", 'count="9"', 'count="many"');
            replaced("/source#p/technique_common/accessor", "count of 1000000000", 'count="3"', 'count="1e9"');
            replaced("/source#p/technique_common/accessor", "stride", 'stride="3"', 'stride="0"');
            replaced("/source#p/technique_common/accessor", "stride", 'stride="3"', '');
            replaced("/source#p/technique_common/accessor", "X, Y and Z", '<param name="Z" type="float"/>', '');
            replaced("/source#p/technique_common/accessor", "no <float_array> with the id \"g\"", '"#f"', '"#g"');
            replaced("/source#p", "<technique_common>", "technique_common", "technique");
            replaced("/vertices#v", "no <source> with the id \"q\"", 'source="#p"', 'source="#q"', "/input");
            replaced("/vertices#v", "POSITION", "POSITION", "NORMAL");
        }

        [Test]
        public function brokenPrimitives():void
        {
            const TRIANGLES:String = Collada.triangles("0 1 2");
            mesh("/triangles", "0 to 2, but found \"3\"", POINTS, Collada.triangles("0 1 3"));
            mesh("/triangles", "found \"-1\"", POINTS, Collada.triangles("0 1 -1"));
            mesh("/triangles", "found \"0.5\"", POINTS, Collada.triangles("0 1 0.5"));
            mesh("/triangles", "found \"x\"", POINTS, Collada.triangles("0 1 x"));
            mesh("/triangles[2]", "three corners", POINTS, TRIANGLES +
                    Collada.triangles("0 1").replace(/count="[^"]*"/, ""));
            mesh("/triangles", "count is 1000000000", POINTS, TRIANGLES.replace('"1"', '"1000000000"'));
            mesh("/triangles", "semantic VERTEX", POINTS, TRIANGLES.replace("VERTEX", "NORMAL"));
            mesh("/triangles", "2 indices for each corner", POINTS, TRIANGLES.replace('"0"', '"1"'));
            mesh("/triangles/input", "offset", POINTS, TRIANGLES.replace('"0"', '"1e9"'));
            mesh("/triangles/input", "offset", POINTS, TRIANGLES.replace('"0"', '"-1"'));
            mesh("/triangles/input", "\"#id\"", POINTS, TRIANGLES.replace("#v", "v"));
            mesh("/polylist/vcount", "found \"-3\"", POINTS, Collada.polylist("-3", "0 1 2"));
            mesh("/polylist/vcount", "found \"1e9\"", POINTS, Collada.polylist("1e9", "0 1 2"));
            mesh("/polylist/vcount", "a polygon's corners, 0 to 1, but found \"2\"", POINTS, Collada.polylist("2 2", "0 1 2"));
            mesh("/polylist", "count is 2", POINTS, Collada.polylist("3", "0 1 2").replace('"1"', '"2"'));
            mesh("/polygons", "found \"9\"", POINTS, '<polygons count="1">' + Collada.INPUT + "<p>0 1 9</p></polygons>");
            mesh("/polygons/ph", "expected a <p>", POINTS, '<polygons count="1">' + Collada.INPUT +
                    "<ph><h>0 1 2</h></ph></polygons>");
            mesh("/trifans", "count is 3", POINTS, '<trifans count="3">' + Collada.INPUT + "<p>0 1 2</p></trifans>");
        }

        [Test]
        public function brokenScenes():void
        {
            const LIBRARY:String = Collada.geometry("a", POINTS, Collada.triangles("0 1 2"));
            scene("node#n/instance_geometry", "no <geometry> with the id \"b\"",
                    '<node id="n"><instance_geometry url="#b"/></node>');
            scene("node/instance_geometry", "of an element in this file, but found \"other.dae#a\"",
                    '<node><instance_geometry url="other.dae#a"/></node>');
            scene("node/instance_node", "no <node>", '<node><instance_node/></node>'.replace("/>", ' url="#x"/>'));
            scene("node/matrix", "expected 16 numbers, but found 3", "<node><matrix>1 0 0</matrix></node>");
            scene("node[2]/matrix", "last row", "<node/><node><matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1</matrix></node>");
            scene("node/rotate", "finite", "<node><rotate>0 0 1 up</rotate></node>");
            scene("node/lookat", "two different points", "<node><lookat>1 1 1 1 1 1 0 0 1</lookat></node>");
            scene("node/lookat", "two different points", "<node><lookat>1 1 1 1 1 2 0 0 1</lookat></node>");
            scene("node/skew", "two different axes", "<node><skew>10 0 0 1 0 0 1</skew></node>");
            scene("node#n/instance_geometry", "too large",
                    '<node id="n"><scale>1e308 1 1</scale><scale>1e308 1 1</scale><instance_geometry url="#a"/></node>');
            fails("scene/instance_visual_scene", "no <visual_scene>", Collada.scene(LIBRARY,
                        NODE).replace("url=\"#s\"", "url=\"#t\""));
            fails("asset/up_axis", "X_UP, Y_UP or Z_UP", Collada.document(LIBRARY, "", "<up_axis>UP</up_axis>"));
            Failures.assertFails("", "name", create, ColladaModel, "", Collada.scene(LIBRARY, NODE));
        }

        [Test]
        public function circles():void
        {
            scene("node#n/node/instance_node", "recursive instance_node",
                    '<node id="n"><node><instance_node url="#n"/></node></node>');
            fails("library_nodes/node#y/instance_node", "recursive instance_node",
                    Collada.scene('<library_nodes><node id="x"><instance_node url="#y"/></node>' +
                        '<node id="y"><instance_node url="#x"/></node></library_nodes>',
                        '<node><instance_node url="#x"/></node>'));
            fails("library_visual_scenes/visual_scene#s/node/instance_controller", "circle",
                    Collada.scene('<library_controllers><controller id="c">' +
                        '<skin source="#d"/></controller><controller id="d"><morph source="#c"/></controller></library_controllers>',
                        '<node><instance_controller url="#c"/></node>'));
        }

        [Test]
        public function chainsOfControllers():void
        {
            assertEquals(9, new ColladaModel("a", inControllers(16)).vertices.length);
            fails(null, "more than 16 controllers follow one another", inControllers(17));
        }

        // A triangle at the end of a chain of so many controllers.
        private static function inControllers(count:int):String
        {
            var chain:String = "";
            for (var i:int = 1; i <= count; i++)
            {
                chain += '<controller id="c' + i + '"><morph source="#' + (i == count ? "a" : "c" + (i + 1)) + '"/></controller>';
            }
            return Collada.scene(Collada.geometry("a", POINTS, Collada.triangles("0 1 2")) + "<library_controllers>" + chain + "</library_controllers>",
                    '<node><instance_controller url="#c1"/></node>');
        }

        [Test(timeout="600000")]
        public function manyOfManyOfMany():void
        {
            var nodes:String = '<node id="n0"><instance_geometry url="#a"/></node>';
            for (var i:int = 1; i < 40; i++)
            {
                nodes += '<node id="n' + i + '"><instance_node url="#n' + (i - 1) + '"/><instance_node url="#n' +
                    (i - 1) + '"/></node>';
            }
            var error:ModelError = Failures.of(function():void
                {
                    new ColladaModel("a", Collada.scene(Collada.geometry("a", POINTS, Collada.triangles("0 1 2")) +
                                "<library_nodes>" + nodes +
                                "</library_nodes>", '<node><instance_node url="#n39"/></node>'));
                });
            assertTrue(error.message, error.message.indexOf(" elements, values, nodes, transforms and instances, each counted as often") >= 0);
        }

        [Test]
        public function manyVertices():void
        {
            var strip:Array = [];
            var points:Array = [];
            for (var i:int = 0; i < 5000; i++)
            {
                points.push(i, i * i, 0);
                strip.push(i);
            }
            var nodes:Array = [];
            for (i = 0; i < 201; i++)
            {
                nodes.push('<instance_geometry url="#a"/>');
            }
            fails("library_visual_scenes/visual_scene#s/node/instance_geometry[201]", "more than 1000000 vertices",
                    Collada.scene(Collada.geometry("a",
                            points.join(" "), '<tristrips count="1">' + Collada.INPUT + "<p>" + strip.join(" ") +
                            "</p></tristrips>"), "<node>" +
                        nodes.join("") + "</node>"));
        }

        [Test]
        public function deepNesting():void
        {
            assertEquals(9, new ColladaModel("a", inNodes(255)).vertices.length);
            fails(null, "nested more than 256 deep", inNodes(256));
            fails("", "no vertices", "<COLLADA>" + nested(999) + "</COLLADA>");
            fails("line 1", "nested more than 1000 deep", "<COLLADA>" + nested(1000) + "</COLLADA>");
            fails("line 1", "nested more than 1000 deep", "<COLLADA>" + new Array(1001).join('<a b="/>">'));
            fails("", "no vertices", "<COLLADA>" + new Array(2001).join("<a b='>'/><!-- <b> --><![CDATA[<c>]]><?d <e>?>") + "</COLLADA>");
        }

        // A triangle in so many nodes, and its own.
        private static function inNodes(count:int):String
        {
            return Collada.scene(Collada.geometry("a", POINTS, Collada.triangles("0 1 2")),
                    new Array(count + 1).join("<node>") + NODE + new Array(count + 1).join("</node>"));
        }

        [Test]
        public function manyElementsAndAttributes():void
        {
            fails("line 500001", "more than 500000 elements", "<COLLADA>" + new Array(500001).join("\n<a/>") + "</COLLADA>");
            fails("line 1", "more than 100 attributes", "<COLLADA" + attributes(101) + "/>");
            fails("", "no vertices", "<COLLADA" + attributes(100) + "/>");
        }

        [Test(timeout="600000")]
        public function fewElementsPlacedOften():void
        {
            var parts:Array = [new Array(3001).join("<translate>0 0 0</translate>"), new Array(3001).join('<instance_geometry url="#a"/>')];
            for each (var part:String in parts)
            {
                fails(null, " elements, values, nodes, transforms and instances, each counted as often", Collada.scene(Collada.geometry("a", POINTS,
                                Collada.triangles("0 1 2")) + '<library_nodes><node id="b">' + part + "</node></library_nodes>",
                            "<node>" + new Array(101).join('<instance_node url="#b"/>') + "</node>"));
            }
        }

        [Test(timeout="600000")]
        public function manyMeshesOfOneSource():void
        {
            var meshes:String = "";
            for (var i:int = 0; i < 500; i++)
            {
                meshes += '<geometry id="g' + i + '"><mesh><triangles count="1"><input semantic="POSITION" source="#p" offset="0"/>' +
                    "<p>0 1 2</p></triangles></mesh></geometry>";
            }
            fails(null, " numbers, each counted as often as it is used", Collada.document(Collada.geometry("a", new Array(10001).join(POINTS + " "),
                            Collada.triangles("0 1 2")) + "<library_geometries>" + meshes + "</library_geometries>"));
        }

        [Test(timeout="600000")]
        public function manyLists():void
        {
            var lists:String = "<triangles>" + Collada.INPUT + new Array(20001).join("<p>0 1 2</p>") + "</triangles>";
            var model:ColladaModel = new ColladaModel("a", Collada.document(Collada.geometry("a", POINTS, lists)));
            assertEquals(60000, model.triangles.length);
            mesh("/triangles[20001]", "found \"9\"", POINTS, new Array(20001).join('<triangles count="0"/>') +
                    '<triangles count="1">' + Collada.INPUT + "<p>0 1 9</p></triangles>");
        }

        [Test]
        public function idsThatAreNamesOfProperties():void
        {
            for each (var id:String in ["constructor", "toString", "hasOwnProperty", "__proto__"])
            {
                var text:String = Collada.scene(Collada.geometry("a", POINTS, Collada.triangles("0 1 2")), NODE);
                text = text.replace('id="a"', 'id="' + id + '"').replace('"#a"', '"#' + id + '"');
                text = text.replace('id="p"', 'id="' + id + '"').replace('"#p"', '"#' + id + '"');
                assertEquals(9, new ColladaModel("a", text).vertices.length);
            }
        }

        private static function nested(depth:int):String
        {
            return new Array(depth + 1).join("<node>") + new Array(depth + 1).join("</node>");
        }

        private static function attributes(count:int):String
        {
            var text:String = "";
            for (var i:int = 0; i < count; i++)
            {
                text += " a" + i + '=""';
            }
            return text;
        }

        private static function scene(place:String, words:String, nodes:String):void
        {
            fails("library_visual_scenes/visual_scene#s/" + place, words, Collada.scene(Collada.geometry("a", POINTS,
                            Collada.triangles("0 1 2")), nodes));
        }

        private static function mesh(place:String, words:String, points:String, primitives:String):void
        {
            fails(MESH + place, words, Collada.document(Collada.geometry("a", points, primitives)));
        }

        private static function replaced(place:String, words:String, what:String, replacement:String,
                more:String = ""):void
        {
            const TEXT:String = Collada.document(Collada.geometry("a", POINTS, Collada.triangles("0 1 2")));
            assertTrue(what, TEXT.indexOf(what) >= 0);
            fails(MESH + place + more, words, TEXT.split(what).join(replacement));
        }

        private static function fails(place:String, words:String, text:String):void
        {
            var error:ModelError = Failures.of(create, ColladaModel, "a", text);
            assertTrue(error.message, error.message.indexOf(words) >= 0);
            if (place != null)
            {
                assertEquals(error.message, place, error.place);
            }
        }
    }
}
