package starlogo.models
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import support.Collada;
    import support.assertClose;
    import support.assertThrows;
    import support.encoded;

    /**
     * The animations of COLLADA documents: the numbers of their keys, skins and morphs, and what is refused. What three.js makes of real
     * documents is in test/adapters.
     */
    public class ColladaAnimationsTest
    {
        private static const POINTS:String = "1 0 0 3 0 0 0 4 0 0 0 5";
        private static const SIDES:String = "0 1 2 0 1 3";

        [Test]
        public function componentsMove():void
        {
            assertPoint(moved("translate.X", "0 0 0 0", "LINEAR"), 0.5, "1 0 7");
            assertPoint(moved("translate.Y", "0 4 8 8", "LINEAR"), 0.5, "1 2 7");
            assertPoint(moved("translate.Z", "0 4 8 8", "LINEAR"), 9, "1 0 8");
            assertPoint(moved("translate(1)", "2 4 8 8", "LINEAR"), -1, "1 2 7");
            assertPoint(moved("translate", "0 0 0 2 4 6 0 0 0 0 0 0", "LINEAR", 3), 0.5, "2 2 3");
            assertPoint(moved("rotate.ANGLE", "0 180 180 180", "LINEAR"), 0.5, "0 1 7");
            assertPoint(moved("rotate", "0 0 1 90 0 0 1 90 0 0 1 90 0 0 1 90", "LINEAR", 4), 0.5, "0 1 7");
            assertPoint(moved("scale.X", "2 4 4 4", "LINEAR"), 0.5, "3 0 7");
        }

        [Test]
        public function matricesMove():void
        {
            const ONE:String = "1 0 0 2 0 1 0 3 0 0 1 4 0 0 0 1";
            const OTHER:String = " 0 -1 0 2 1 0 0 3 0 0 1 4 0 0 0 1";
            const KEYS:String = ONE + OTHER + OTHER + OTHER;
            assertPoint(moved("matrix", KEYS, "LINEAR", 16), 0, "3 3 11");
            assertPoint(moved("matrix", KEYS, "LINEAR", 16), 1, "2 4 11");
            // each number on its own
            assertPoint(moved("matrix", KEYS, "LINEAR", 16), 0.5, "2.5 3.5 11");
            // column and row, or the index in the rows
            assertPoint(moved("matrix(3)(1)", "5 5 5 5", "LINEAR"), 0, "1 5 7");
            assertPoint(moved("matrix(7)", "5 5 5 5", "LINEAR"), 0, "1 5 7");
        }

        [Test]
        public function keysMayStepAndCurve():void
        {
            assertPoint(moved("translate.X", "0 4 8 8", "STEP"), 0.9, "1 0 7");
            assertPoint(moved("translate.X", "0 4 8 8", "STEP"), 1, "5 0 7");
            assertPoint(moved("translate.X", "0 4 8 8", "LINEAR STEP LINEAR LINEAR"), 0.5, "3 0 7");
            assertPoint(moved("translate.X", "0 4 8 8", "LINEAR STEP LINEAR LINEAR"), 1.5, "5 0 7");
            // control points at thirds make a line, at the keys' heights a curve that is slow at both ends
            assertPoint(moved("translate.X", "0 3 3 3", "BEZIER", 1, "1 3 3 3", "-1 2 3 3"), 0.25, "1.75 0 7");
            assertPoint(moved("translate.X", "0 4 4 4", "BEZIER", 1, "0 4 4 4", "0 4 4 4"), 0.25, "1.625 0 7");
            // with times: all control points at half of the time, so that the time is at 0.25 where 3ss(1-s) + 3s(1-s)(1-s) + 2s^3 = 0.5
            const HALVES:String = "0.5 0 1.5 4 2.5 4 3.5 4";
            const BEFORE:String = "-0.5 0 0.5 4 1.5 4 2.5 4";
            assertPoint(moved("translate.X", "0 4 4 4", "BEZIER", 1, HALVES, BEFORE), 0.5, "3 0 7");
            var share:Number = 0.25;
            var time:Number = 1.5 * share * (1 - share) + share * share * share;
            assertPoint(moved("translate.X", "0 4 4 4", "BEZIER", 1, HALVES, BEFORE), time, (1 + 4 * (3 * share * share * (1 - share) + share * share * share)) + " 0 7");
        }

        /** So a matrix keeps its last row, 0 0 0 1, on every curve. */
        [Test]
        public function equalNumbersStayOnCurves():void
        {
            const KEY:String = "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1";
            const KEYS:String = [KEY, KEY.replace("1 0 0 0", "1 0 0 5"), KEY, KEY].join(" ");
            var animations:ColladaAnimations = new ColladaAnimations("a", moved("matrix", KEYS, "BEZIER", 16, KEYS, KEYS));
            for (var i:int = 0; i <= 300; i++)
            {
                assertEquals("0,7", animations.verticesAt(0, i / 100).slice(1, 3).join());
            }
        }

        [Test]
        public function animationsMayBeNestedAndClipsChosen():void
        {
            var inner:String = animation("n/translate.X", "0 4 8 8", "LINEAR").replace("<animation", '<animation id="inner"');
            var outer:String = animation("n/translate.Y", "0 4 8 8", "LINEAR").replace("<animation", '<animation id="outer"').replace("</animation>", inner + "</animation>");
            assertPoint(documentOf(outer), 1, "5 4 7");
            var clips:String = '<library_animation_clips><animation_clip name="both" start=" 1" end="2\n"><instance_animation url=" #outer "/></animation_clip>' +
                '<animation_clip id="one"><instance_animation url="#inner"/></animation_clip></library_animation_clips>';
            var animations:ColladaAnimations = new ColladaAnimations("a", documentOf(outer, clips));
            assertEquals("2,0,1,-1", [animations.count, animations.indexOf("both"), animations.indexOf("one"), animations.indexOf("")].join());
            assertEquals("1,3", [animations.durationOf(0), animations.durationOf(1)].join());
            assertEquals("5,4,7", animations.verticesAt(0, -1).slice(0, 3).join());
            assertEquals("7,6,7", animations.verticesAt(0, 0.5).slice(0, 3).join());
            assertEquals("9,8,7", animations.verticesAt(0, 5).slice(0, 3).join());
            assertEquals("3,0,7", animations.verticesAt(1, 0.5).slice(0, 3).join());
        }

        /** While the joints are where the skin was bound, the pose is the model. */
        [Test]
        public function jointsMoveSkins():void
        {
            for each (var isById:Boolean in [false, true])
            {
                var text:String = skinned("joint/turn.ANGLE", "0 90 90 90", isById);
                var model:ColladaModel = new ColladaModel("a", text, null, Model.AS_GIVEN);
                var animations:ColladaAnimations = new ColladaAnimations("a", text);
                assertPoints(model.vertices.join(" "), animations.verticesAt(0, 0));
                // Point 0 is on the joint that turns about (1, 0, 0). Point 1 is on both in equal parts, the others
                // are on the one that stays, point 3 because it is on none.
                assertPoints("1 0 0 2 1 0 0 4 0 0 0 5", animations.verticesAt(0, 1));
            }
        }

        /** A model shows a skin where its joints are while nothing moves, wherever it was bound. */
        [Test]
        public function modelsShowSkinsAtTheirJoints():void
        {
            var turned:String = skinned("joint/turn.ANGLE", "90 90 90 90", false).replace(">0 0 1 0</rotate>", ">0 0 1 90</rotate>");
            var model:ColladaModel = new ColladaModel("a", turned, null, Model.AS_GIVEN);
            assertPoints("1 0 0 2 1 0 0 4 0 0 0 5", model.vertices);
            assertPoints(model.vertices.join(" "), new ColladaAnimations("a", turned).verticesAt(0, 0));
            assertEquals("0,1,2,0,1,3", model.triangles.join());
            var mirrored:String = turned.replace('sid="still">', 'sid="still"><scale>1 1 -1</scale>');
            assertEquals("0,2,1,0,3,1", new ColladaModel("a", mirrored, null, Model.AS_GIVEN).triangles.join());
        }

        /** What does not move needs no joints, so a model shows a skin that is wrong where it was bound. */
        [Test]
        public function modelsShowWrongSkinsWhereTheyWereBound():void
        {
            var text:String = skinned("joint/turn.ANGLE", "90 90 90 90", false).replace("<node><instance_controller", "<node><scale>1 1 -1</scale><instance_controller");
            for each (var wrong:String in [text.replace("still bone", "still other bone"), text.replace("still bone", "still other"),
                        text.replace("#root<", "#gone<"), text.replace("0 0 1 0 0 0 0 1 1 0", "0 0 1 0 0 0 0 2 1 0"), text.replace("<v>1 1", "<v>2 1"),
                        text.replace("1 2 1 0<", "1 1 1 0<"), text.replace(">1 .5<", ">1e308 1e308<"), text.replace(/joints>/g, "jointsx>")])
            {
                var model:ColladaModel = new ColladaModel("a", wrong, null, Model.AS_GIVEN);
                assertPoints("1 0 0 3 0 0 0 4 0 0 0 -5", model.vertices);
                assertEquals("0,2,1,0,3,1", model.triangles.join());
            }
            assertThrows(ModelError, /bind_shape_matrix: expected 16 numbers/, function():void
                {
                    new ColladaModel("a", text.replace("<bind_shape_matrix>1", "<bind_shape_matrix>"));
                });
        }

        /** All that place a skin share it. What is too much for the limits is where it was bound. */
        [Test]
        public function skinsMayBePlacedOften():void
        {
            var text:String = skinned("joint/turn.ANGLE", "90 90 90 90", false).replace(">0 0 1 0</rotate>", ">0 0 1 90</rotate>");
            for each (var influences:int in [200, 2000])
            {
                var much:String = text.replace("1 2 1 0<", "1 2 " + influences + " 0<").replace("<v>1 1 1 1 0 1 0 0", "<v>1 1 1 1 0 1" + repeated(" 0 0", influences));
                much = much.replace(/<node><instance_controller.*?<\/node>/, repeated("$&", 300));
                var vertices:Vector.<Number> = new ColladaModel("a", much, null, Model.AS_GIVEN).vertices;
                assertEquals(300 * 12, vertices.length);
                assertPoints("1 0 0 2 1 0 0 4 0 0 0 5", vertices.slice(0, 12));
                assertPoints(influences == 200 ? "1 0 0 2 1 0 0 4 0 0 0 5" : "1 0 0 3 0 0 0 4 0 0 0 5", vertices.slice(299 * 12));
            }
        }

        private static function repeated(text:String, count:int):String
        {
            var all:String = "";
            for (var i:int = 0; i < count; i++)
            {
                all += text;
            }
            return all;
        }

        /** Each follows the joints that are placed with it, even if all are one node of the document. */
        [Test]
        public function figuresThatAreOneNodeHaveTheirOwnJoints():void
        {
            const PLACES:String = '<node id="p"><translate>0 0 10</translate><instance_node url="#q"/></node><instance_node url="#q"/>' +
                '<node id="q"><translate>0 20 0</translate><instance_node url="#figure"/></node><node><instance_node url="#figure"/></node>';
            var text:String = skinned("joint/turn.ANGLE", "0 90 90 90", false).replace(/(<visual_scene id="s">)(.*)(<\/visual_scene>)/,
                    '$1<node id="shown">' + PLACES.replace(/<node id="q">.*?<\/node>/, "") + "</node>$3<node id=\"figure\">$2</node>");
            text = text.replace(/(<node id="figure">.*<\/node>)(<\/library_visual_scenes>)/, "$2<library_nodes>$1" +
                    /<node id="q">.*?<\/node>/.exec(PLACES)[0] + "</library_nodes>");
            assertPoints("1 20 10 2 21 10 0 24 10 0 20 15 1 20 0 2 21 0 0 24 0 0 20 5 1 0 0 2 1 0 0 4 0 0 0 5", new ColladaAnimations("a", text).verticesAt(0, 1));
            // the skin beside the place of its joints
            text = skinned("joint/turn.ANGLE", "0 90 90 90", false);
            var joints:String = /<node id="root".*<\/node>(?=<node><instance_controller)/.exec(text)[0];
            var skin:String = /<instance_controller.*<\/instance_controller>/.exec(text)[0];
            text = text.replace(joints + "<node>" + skin + "</node>", '<node><translate>0 0 10</translate><instance_node url="#root"/><node>' + skin +
                    '</node></node><node><instance_node url="#root"/>' + skin + "</node>" + skin);
            text = text.replace("<library_animations>", "<library_nodes>" + joints + "</library_nodes><library_animations>");
            assertPoints("1 0 10 2 1 10 0 4 10 0 0 15 1 0 0 2 1 0 0 4 0 0 0 5 1 0 10 2 1 10 0 4 10 0 0 15", new ColladaAnimations("a", text).verticesAt(0, 1));
        }

        [Test]
        public function sidsMayHaveDots():void
        {
            var text:String = moved("move.to.X", "0 4 8 8", "LINEAR").replace('sid="translate"', 'sid="move.to"');
            assertPoint(text, 0.5, "3 0 7");
            text = moved("move.X", "0 0 0 4 0 0 8 0 0 8 0 0", "LINEAR", 3).replace('sid="translate"', 'sid="move.X"');
            assertPoint(text, 0.5, "3 0 0");
        }

        [Test]
        public function weightsOfMorphsMove():void
        {
            assertPoints("1 0 0 3 0 0 0 4 0 0 0 5", new ColladaAnimations("a", morphed("NORMALIZED")).verticesAt(0, 0));
            assertPoints("1 1 1 2 1 1 .5 3 1 .5 1 3.5", new ColladaAnimations("a", morphed("NORMALIZED")).verticesAt(0, 1));
            assertPoints("1.5 1 1 3.5 1 1 .5 5 1 .5 1 6", new ColladaAnimations("a", morphed("RELATIVE")).verticesAt(0, 1));
        }

        /** An animation moves the numbers of an array, of which the weights may be a part. */
        [Test]
        public function weightsMayBeAPartOfTheirArray():void
        {
            var text:String = morphed("RELATIVE").replace(">0</float_array>", ">9 0</float_array>").replace('"weights" count="1"', '"weights" count="2"')
                .replace('"#weights" count="1"', '"#weights" offset="1" count="1"').replace("weights(0)", "weights(1)");
            assertPoints("1.5 1 1 3.5 1 1 .5 5 1 .5 1 6", new ColladaAnimations("a", text).verticesAt(0, 1));
        }

        /** There may be words between weights, which count for nothing. */
        [Test]
        public function weightsMayHaveAStride():void
        {
            var morph:String = morphed("RELATIVE", "b b").replace(">0</float_array>", ">0 9 0 9</float_array>").replace('"weights" count="1"', '"weights" count="4"')
                .replace('"#weights" count="1" stride="1"', '"#weights" count="2" stride="2"').replace("weights(0)", "weights(2)");
            assertPoints("1.5 1 1 3.5 1 1 .5 5 1 .5 1 6", new ColladaAnimations("a", morph).verticesAt(0, 1));
            var skin:String = skinned("joint/turn.ANGLE", "0 90 90 90", false).replace(">1 .5<", ">1 9 .5 9<").replace('"WEIGHTf" count="2"', '"WEIGHTf" count="4"')
                .replace('"#WEIGHTf" count="2" stride="1"', '"#WEIGHTf" count="2" stride="2"');
            assertPoints("1 0 0 2 1 0 0 4 0 0 0 5", new ColladaAnimations("a", skin.replace("<v>1 1 1 1 0 1 0 0", "<v>1 0 1 1 0 1 0 0")).verticesAt(0, 1));
            fails(/expected a weight's index, 0 to 1, but found "2"/, skin.replace("<v>1 1", "<v>1 2"));
        }

        /** An element's numbers are found once for a pose, and hold at each of its places. */
        [Test]
        public function eachPlaceOfANodeHasItsChannels():void
        {
            var often:ColladaAnimations = placedOften(500);
            var before:Vector.<Number> = often.verticesAt(0, 0);
            var moved:Vector.<Number> = often.verticesAt(0, 0.5);
            assertEquals(12 * 4096, moved.length);
            for (var i:int = 0; i < moved.length; i++)
            {
                assertEquals(before[i % 12] + (i % 3 == 0 ? 2 : 0), moved[i]);
            }
        }

        /** Of as many poses as a game has: none of them takes from what reading the file may cost. */
        [Test]
        public function posesAreManyAndFitTheModel():void
        {
            var text:String = skinned("joint/turn.ANGLE", "0 90 90 0", false).replace("Z_UP", "Y_UP").replace("<up_axis>", '<unit meter="0.5"/><up_axis>');
            for each (var scaling:String in [Model.FOOTPRINT, Model.AS_GIVEN])
            {
                var model:ColladaModel = ColladaModel.fromBytes("a", encoded(text), null, scaling);
                var animations:ColladaAnimations = ColladaAnimations.fromBytes("a", encoded(text));
                var first:Vector.<Number> = model.vertices.slice();
                for (var i:int = 0; i < 2000; i++)
                {
                    model.pose(animations.verticesAt(0, 2));
                }
                assertTrue(Math.abs(first[3] - model.vertices[3]) > 0.01);
                model.pose(animations.verticesAt(0, 3));
                assertPoints(first.join(" "), model.vertices);
            }
        }

        [Test]
        public function pointsThatNoTriangleUsesAreLeftOut():void
        {
            var text:String = moved("translate.X", "0 4 8 8", "LINEAR").replace("<p>0 1 2 0 1 3</p>", "<p>0 1 3 0 1 3</p>");
            assertEquals(9, new ColladaModel("a", text).vertices.length);
            assertPoints("5 0 7 7 0 7 4 0 12", new ColladaAnimations("a", text).verticesAt(0, 1));
            // of a skin, whose weights are for all points
            text = skinned("joint/turn.ANGLE", "0 90 90 90", false).replace("<p>0 1 2 0 1 3</p>", "<p>1 2 3 1 2 3</p>");
            assertEquals(9, new ColladaModel("a", text).vertices.length);
            assertPoints("2 1 0 0 4 0 0 0 5", new ColladaAnimations("a", text).verticesAt(0, 1));
        }

        [Test]
        public function targetsMayBeginAtTheScene():void
        {
            var text:String = documentOf(animation("s/here/translate.X", "0 4 8 8", "LINEAR")).replace('id="n"', 'id="n" sid="here"');
            assertPoint(text, 1, "5 0 7");
        }

        [Test]
        public function whatMovesNoVertexIsIgnored():void
        {
            var text:String = documentOf(animation("light/color", "0 0 0 0", "LINEAR"));
            assertEquals("1,0", [new ColladaAnimations("a", text).count, new ColladaAnimations("a", text).durationOf(0)].join());
            assertPoint(moved("visibility", "0 0 0 0", "LINEAR"), 1, "1 0 7");
            assertEquals(0, new ColladaAnimations("a", documentOf("")).count);
            assertThrows(RangeError, /the file has no animations/, new ColladaAnimations("a", documentOf("")).verticesAt, 0, 0);
            assertThrows(RangeError, /finite/, new ColladaAnimations("a", text).verticesAt, 0, NaN);
        }

        [Test]
        public function whatIsWrongInAnimationsIsNamed():void
        {
            fails(/library_animations\/animation\/channel: expected a target like/, moved("translate(X)", "0 0 0 0", "LINEAR"));
            fails(/channel: there is no such number in the <translate>/, moved("translate.ANGLE", "0 0 0 0", "LINEAR"));
            fails(/channel: there is no such number in the <translate>/, moved("translate(4294967296)", "0 0 0 0", "LINEAR"));
            fails(/channel: there is no such number in the <matrix>/, moved("matrix(4)(0)", "0 0 0 0", "LINEAR"));
            fails(/channel: there is no such number in the <matrix>/, moved("matrix(0)(4)", "0 0 0 0", "LINEAR"));
            fails(/channel: there is no such number in the <matrix>/, moved("matrix.X", "0 0 0 0", "LINEAR"));
            // an array is no matrix, even if it has as many numbers
            var weights:String = morphed("RELATIVE").replace(">0</float_array>", ">0" + repeated(" 0", 15) + "</float_array>").replace('"weights" count="1"', '"weights" count="16"');
            assertEquals(1, new ColladaAnimations("a", weights).count);
            fails(/channel: there is no such number in the <float_array>/, weights.replace("weights(0)", "weights(0)(0)"));
            fails(/channel: its sampler has 1 numbers for each key, but expected 3/, moved("translate", "0 0 0 0", "LINEAR"));
            fails(/channel: its sampler has 3 numbers for each key, but expected 1/, moved("translate.X", "0 0 0 0 0 0 0 0 0 0 0 0", "LINEAR", 3));
            fails(/sampler#t: expected as many of OUTPUT as of INPUT/, moved("translate.X", "0 0 0", "LINEAR"));
            fails(/sampler#t: expected as many of INTERPOLATION/, moved("translate.X", "0 0 0 0", "LINEAR LINEAR"));
            fails(/sampler#t: expected LINEAR, STEP or BEZIER, but found "SMOOTH"/, moved("translate.X", "0 0 0 0", "LINEAR SMOOTH LINEAR LINEAR"));
            fails(/sampler#t: expected an <input> with the semantic OUT_TANGENT/, moved("translate.X", "0 0 0 0", "BEZIER"));
            fails(/sampler#t: expected 1 or 2 numbers in each OUT_TANGENT, but found 3/,
                    moved("translate.X", "0 0 0 0", "BEZIER", 1, "0 0 0 0 0 0 0 0 0 0 0 0", "0 0 0 0"));
            fails(/sampler#t: its tangents are of different kinds/, moved("translate.X", "0 0 0 0", "BEZIER", 1, "0 0 0 0 0 0 0 0", "0 0 0 0"));
            fails(/sampler#t: its times must be finite and not go back, but found 1$/, moved("translate.X", "0 0 0 0", "LINEAR").replace("0 1 2 3", "0 2 1 3"));
            fails(/float_array#OUTPUTf: expected finite numbers, but found "x"/, moved("translate.X", "0 0 x 0", "LINEAR"));
            fails(/accessor: its count of 5 with a stride of 1 reaches beyond the 4/, moved("translate.X", "0 0 0 0", "LINEAR").replace('"#OUTPUTf" count="4"', '"#OUTPUTf" count="5"'));
            fails(/animation_clip#c: it ends before it starts/, documentOf("", '<library_animation_clips><animation_clip id="c" start="2" end="1"/></library_animation_clips>'));
            fails(/no <animation> with the id "x"/, documentOf("", '<library_animation_clips><animation_clip><instance_animation url="#x"/></animation_clip></library_animation_clips>'));
            fails(/root element is <svg>/, "<svg/>");
            var far:ColladaAnimations = new ColladaAnimations("a", moved("translate.X", "-1e308 1e308 0 0", "LINEAR"));
            assertThrows(ModelError, /sampler#t: its numbers at 0.5 seconds are not finite/, far.verticesAt, 0, 0.5);
            assertEquals(12, far.verticesAt(0, 2).length);
        }

        [Test]
        public function whatIsWrongInSkinsIsNamed():void
        {
            var text:String = skinned("joint/turn.ANGLE", "0 90 90 90", false);
            fails(/Name_array#JOINTf: there is no joint "other" in the skeleton/, text.replace("still bone", "still other"));
            fails(/skeleton: there is no <node> with the id "gone"/, text.replace("#root<", "#gone<"));
            fails(/skin: its joint "still" is not in the scene/, text.replace("#root<", "#far<").replace("<library_animations>",
                        '<library_nodes><node id="far" sid="still"><node sid="bone"/></node></library_nodes><library_animations>'));
            fails(/joints: expected at least one joint, and a matrix for each, but found 2 and 1/, text.replace('count="2" stride="16"', 'count="1" stride="16"'));
            fails(/float_array#INV_BIND_MATRIXf: expected a last row of 0 0 0 1/, text.replace("0 0 1 0 0 0 0 1 1 0", "0 0 1 0 0 0 0 2 1 0"));
            // a rounded last row counts as 0 0 0 1
            new ColladaAnimations("a", text.replace("0 0 1 0 0 0 0 1 1 0", "0 0 1 0 0 0 0 0.99999 1 0"));
            fails(/vertex_weights: expected a joint's index, -1 to 1, but found "2"/, text.replace("<v>1 1", "<v>2 1"));
            fails(/vertex_weights: expected 2 indices for each joint of a point, but found 9 in all/, text.replace("<v>1 1", "<v>0 1 1"));
            fails(/vertex_weights: expected a weight's index, 0 to 1, but found "2"/, text.replace("<v>1 1", "<v>1 2"));
            fails(/vertex_weights: its <vcount> adds up to 3 joints, but <v> has 4/, text.replace("1 2 1 0<", "1 1 1 0<"));
            fails(/vertex_weights: its count is 4, but it has 3 numbers in <vcount>/, text.replace("1 2 1 0<", "1 2 1<"));
            fails(/skin: it has weights for 3 points, but its geometry has 4/, text.replace("1 2 1 0<", "1 2 1<").replace('vertex_weights count="4"', 'vertex_weights count="3"'));
            fails(/skin: expected a <joints> in it/, text.replace(/joints>/g, "jointsx>"));
            text = morphed("RELATIVE");
            fails(/morph: there is no <geometry> with the id "c"/, text.replace(">b<", ">c<"));
            fails(/morph: it has 2 targets, but 1 weights/, morphed("RELATIVE", "b b"));
            fails(/morph: its target "b" has another number of points/, morphed("RELATIVE", "b", "1 2 2 1 2 2 1 2 2"));
        }

        /** Many channels, clips or joints cannot make a small document costly. */
        [Test]
        public function costsAreLimited():void
        {
            var many:Array = [];
            for (var i:int = 0; i < 2000; i++)
            {
                many.push('<instance_animation url="#e"/>');
            }
            var empty:String = '<animation id="e">' + many.join("").replace(/<[^>]*>/g, "<extra/>") + "</animation>";
            var clip:String = "<library_animation_clips><animation_clip>" + many.join("") + "</animation_clip></library_animation_clips>";
            fails(/more than .* elements/, documentOf(empty, clip));
        }

        // A node with a geometry and many channels that is in the scene 4096 times.
        private static function placedOften(channels:int):ColladaAnimations
        {
            var moving:String = animation("x/matrix(3)(0)", "0 4 8 8", "LINEAR");
            var channel:String = /<channel.*?>/.exec(moving)[0];
            for (var i:int = 1; i < channels; i++)
            {
                moving = moving.replace("</animation>", channel + "</animation>");
            }
            var geometry:String = '<instance_geometry url="#a"/>';
            var nodes:String = '<node id="x"><matrix sid="matrix">1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix>' + geometry + "</node>";
            for (i = 0; i < 12; i++)
            {
                var inner:String = '<instance_node url="#' + (i == 0 ? "x" : "x" + i) + '"/>';
                nodes += '<node id="x' + (i + 1) + '">' + inner + inner + "</node>";
            }
            var text:String = documentOf(moving).replace(geometry, '<instance_node url="#x12"/>');
            return new ColladaAnimations("a", text.replace("<library_animations>", "<library_nodes>" + nodes + "</library_nodes><library_animations>"));
        }

        private static function fails(problem:RegExp, text:String):void
        {
            assertThrows(ModelError, problem, read, text);
        }

        private static function read(text:String):void
        {
            new ColladaAnimations("a", text);
        }

        // Checks the first point at a time.
        private static function assertPoint(text:String, time:Number, expected:String):void
        {
            assertPoints(expected, new ColladaAnimations("a", text).verticesAt(0, time).slice(0, 3));
        }

        private static function assertPoints(expected:String, found:Vector.<Number>):void
        {
            var numbers:Array = expected.split(" ");
            assertEquals(numbers.length, found.length);
            for (var i:int = 0; i < numbers.length; i++)
            {
                assertClose(Number(numbers[i]), found[i], 1e-12);
            }
        }

        // A node 7 units up, of which a channel moves something.
        private static function moved(target:String, values:String, interpolation:String, width:int = 1, out:String = null, into:String = null):String
        {
            return documentOf(animation("n/" + target, values, interpolation, width, out, into));
        }

        private static function documentOf(animations:String, clips:String = ""):String
        {
            return Collada.scene(Collada.geometry("a", POINTS, Collada.triangles(SIDES)) + "<library_animations>" + animations + "</library_animations>" + clips,
                    '<node id="n"><translate sid="translate">0 0 7</translate><matrix sid="matrix">1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix>' +
                    '<rotate sid="rotate">0 0 1 0</rotate><scale sid="scale">1 1 1</scale><instance_geometry url="#a"/></node>');
        }

        // An animation with keys at 0, 1, 2 and 3 seconds, all of one interpolation if only one is given.
        private static function animation(target:String, values:String, interpolation:String, width:int = 1, out:String = null, into:String = null):String
        {
            var names:String = interpolation.indexOf(" ") < 0 ? [interpolation, interpolation, interpolation, interpolation].join(" ") : interpolation;
            var inputs:String = input("INPUT") + input("OUTPUT") + input("INTERPOLATION") + (out == null ? "" : input("OUT_TANGENT") + input("IN_TANGENT"));
            return "<animation>" + source("INPUT", "0 1 2 3") + source("OUTPUT", values, width) + source("INTERPOLATION", names, 1, "Name_array") +
                (out == null ? "" : source("OUT_TANGENT", out, out.split(" ").length / 4) + source("IN_TANGENT", into, into.split(" ").length / 4)) +
                '<sampler id="t">' + inputs + '</sampler><channel source="#t" target="' + target + '"/></animation>';
        }

        private static function input(semantic:String, offset:int = 0):String
        {
            return '<input semantic="' + semantic + '" source="#' + semantic + '" offset="' + offset + '"/>';
        }

        // A source with an array whose id is given, or the source's id and "f".
        private static function source(id:String, values:String, width:int = 1, array:String = "float_array", arrayId:String = null):String
        {
            var count:int = values.split(" ").length;
            arrayId ||= id + "f";
            return '<source id="' + id + '"><' + array + ' id="' + arrayId + '" count="' + count + '">' + values + "</" + array +
                '><technique_common><accessor source="#' + arrayId + '" count="' + count / width + '" stride="' + width + '"/></technique_common></source>';
        }

        // A skin with a joint that stays and one about which the points turn. It was bound with the turning joint at (1, 0, 0).
        private static function skinned(target:String, values:String, isById:Boolean):String
        {
            var names:String = isById ? source("JOINT", "root joint", 1, "IDREF_array") : source("JOINT", "still bone", 1, "Name_array");
            var skin:String = '<library_controllers><controller id="c"><skin source="#a"><bind_shape_matrix>1 0 0 -1 0 1 0 0 0 0 1 0 0 0 0 1</bind_shape_matrix>' +
                names + source("INV_BIND_MATRIX", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 1 0 0 -1 0 1 0 0 0 0 1 0 0 0 0 1", 16) +
                source("WEIGHT", "1 .5") + "<joints>" + input("JOINT") + input("INV_BIND_MATRIX") + '</joints><vertex_weights count="4">' + input("JOINT") +
                input("WEIGHT", 1) + "<vcount>1 2 1 0</vcount><v>1 1 1 1 0 1 0 0</v></vertex_weights></skin></controller></library_controllers>";
            // the points that the bind shape matrix makes POINTS of
            var points:String = "2 0 0 4 0 0 1 4 0 1 0 5";
            return Collada.scene(Collada.geometry("a", points, Collada.triangles(SIDES)) + skin + "<library_animations>" + animation(target, values, "LINEAR") +
                    "</library_animations>", '<node id="root" sid="still"><node id="joint" sid="bone"><translate>1 0 0</translate><rotate sid="turn">0 0 1 0</rotate></node>' +
                    '</node><node><instance_controller url="#c"><skeleton>#root</skeleton></instance_controller></node>');
        }

        // A morph with one target, whose weight goes from 0 to 0.5.
        private static function morphed(method:String, targets:String = "b", points:String = "1 2 2 1 2 2 1 2 2 1 2 2"):String
        {
            var base:String = Collada.geometry("a", POINTS, Collada.triangles(SIDES));
            var target:String = Collada.geometry("b", points, "");
            var morph:String = '<library_controllers><controller id="c"><morph method="' + method + '" source="#a">' + source("MORPH_TARGET", targets, 1, "IDREF_array") +
                source("MORPH_WEIGHT", "0", 1, "float_array", "weights") + "<targets>" + input("MORPH_TARGET") + input("MORPH_WEIGHT") +
                "</targets></morph></controller></library_controllers>";
            return Collada.scene(base + target + morph + "<library_animations>" + animation("weights(0)", "0 .5 0 0", "LINEAR") + "</library_animations>",
                    '<node id="n"><translate sid="translate">0 0 0</translate><instance_controller url="#c"/></node>');
        }
    }
}
