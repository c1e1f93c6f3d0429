package starlogo.collision
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.steps.StepSequence;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.WorldBounds;
    import support.AgentChanges;
    import support.Complaints;
    import support.EachCollider;
    import support.Effort;
    import support.FrameByFrame;
    import support.SolidModels;
    import support.agentAt;
    import support.assertThrows;
    import support.ignore;
    import support.landOf;

    /**
     * A contact is that of the last frame: how the two touched where they were then, whatever they, their models and their list have become
     * since.
     *
     * <p>Each time there are three colliders that see the same frames: one is asked at once and again after the changes, one after the changes
     * alone, so that keeping answers is not enough, and one after the next frame alone.</p>
     */
    public class ContactsOfTheFrameTest
    {
        private static const SHAPES:Array = ["sphere", "cube", "cylinder", "plank", "apart"];
        private static const CHANGES:Array = [[], ["position"], ["jump"], ["size"], ["heading"], ["pitch"], ["roll"], ["shape"], ["unknown shape"],
                ["hierarchical"], ["collideAs"], ["traversalDepth"], ["sweeps", "breed"]];
        private static const COUNT:int = 5;
        private static const NEAR:Number = 1e-9;

        private static var sGreatLand:GreatLand;

        // whether a test has left others than those that begin() needs
        private static var sAreModelsSpoilt:Boolean;

        // worlds of each collider: no agent sweeps in every other one, and questions are asked in two of four
        private var _rounds:int = Effort.choose(4, 40);
        private var _random:SeededRandom;
        private var _agents:Vector.<Agent>;
        private var _wrong:Complaints;
        private var _isSwept:Boolean;

        // how many contacts were compared, of these with a depth, within a motion, and not like those of where the agents are now
        private var _compared:int;
        private var _deep:int;
        private var _passing:int;
        private var _different:int;

        [BeforeClass]
        public static function makeModels():void
        {
            sGreatLand = new GreatLand();
            sAreModelsSpoilt = true;
        }

        [Before]
        public function begin():void
        {
            if (sAreModelsSpoilt)
            {
                addModels();
            }
            _random = new SeededRandom(1207);
            _wrong = new Complaints();
            _compared = _deep = _passing = _different = 0;
        }

        [Test(async, timeout="3600000")]
        public function stayWhateverAgentsDo():void
        {
            var work:StepSequence = new StepSequence().slices(CHANGES.length, 1, function(first:int, end:int):void
                {
                    var traits:Array = CHANGES[first];
                    // who sweeps or is of another breed touches as before
                    assertContactsStay(traits.join(), function(agents:Array):void
                        {
                            for each (var trait:String in traits)
                            {
                                change(trait, agents);
                            }
                        }, traits.length > 0 && traits[0] != "sweeps");
                });
            work.call(function():void
                {
                    assertContactsStay("all at once", function(agents:Array):void
                        {
                            for (var k:int = _random.integer(2, 8); k > 0; k--)
                            {
                                change(_random.pick(_random.pick(CHANGES.slice(1))), agents);
                            }
                        });
                });
            FrameByFrame.run(this, work, 1, function():void
                {
                });
        }

        [Test]
        public function stayWhateverBecomesOfModels():void
        {
            assertContactsStay("replaced by the same", addModels, false);
            assertContactsStay("replaced by longer planks", addPlanks);
            assertContactsStay("removed", removeModels);
            assertContactsStay("libraries changed directly", changeLibraries);
        }

        [Test]
        public function stayWhenAgentsLeaveTheList():void
        {
            assertContactsStay("some leave", function(agents:Array):void
                {
                    for each (var agent:Agent in agents)
                    {
                        _agents.splice(_agents.indexOf(agent), 1);
                    }
                }, false);
            assertContactsStay("all leave", function(agents:Array):void
                {
                    _agents.length = 0;
                    change("position", agents);
                });
        }

        [Test]
        public function afterTheNextFrameTheyAreThatFrames():void
        {
            for each (var name:String in EachCollider.NAMES)
            {
                for (var round:int = 0; round < _rounds; round++)
                {
                    _isSwept = round % 2 == 1;
                    var asked:Collider = EachCollider.make(name, sGreatLand);
                    var silent:Collider = EachCollider.make(name, sGreatLand);
                    playFrames(asked, silent);
                    contactsOf(asked, _agents);
                    change(_random.pick(["size", "shape", "heading", "hierarchical", "collideAs"]), someOf(_agents));
                    change("position", someOf(_agents));
                    askAll(asked, _agents);
                    contactsOf(asked, _agents);
                    assertSamePairs(name, silent.findCollisions(_agents), asked.findCollisions(_agents));
                    var expected:Vector.<Number> = contactsOf(silent, _agents);
                    compare(name + (_isSwept ? ", swept" : ""), expected, contactsOf(asked, _agents));
                    if (!_isSwept)
                    {
                        // of a frame in which no agent sweeps a new collider gives the same
                        var fresh:Collider = EachCollider.make(name, sGreatLand);
                        fresh.findCollisions(_agents);
                        compare(name + ", a new one", contactsOf(fresh, _agents), expected);
                    }
                }
            }
            _wrong.assertNone();
        }

        [Test]
        public function afterAResetTheyAreThoseOfNow():void
        {
            var collider:Collider = new TightestFitCollider(sGreatLand);
            var collision:Collision = new Collision(collider);
            var a:Agent = new Agent("cube");
            var b:Agent = new Agent("cube");
            for each (var gap:Number in [0.5, 8])
            {
                // no frame tests the two, because they have no handlers
                a.moveTo(2 * gap, 0, 0);
                b.moveTo(3 * gap, 0, 0);
                collision.update(new <Agent>[a, b]);
                b.moveTo(4 * gap, 0, 0);
                assertTrue(gap + " apart", Math.abs(collider.contactOf(a, b).point.x - 2.5 * gap) < NEAR);
                collision.reset();
                assertTrue(2 * gap + " apart", Math.abs(collider.contactOf(a, b).point.x - 3 * gap) < NEAR);
            }
        }

        // The place stays that of the frame. The shape is that of the pose.
        [Test]
        public function aPoseCountsAtOnce():void
        {
            for each (var isExact:Boolean in [false, true])
            {
                var model:Model = new Model("tetrahedron", new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1], new <uint>[0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]);
                var land:GreatLand = landOf(model);
                var collider:HierarchicalCollider = new HierarchicalCollider(land);
                collider.exact = isExact;
                var collision:Collision = new Collision(collider);
                collision.terrain = new Terrain(10, 10, 1, -5, -5);
                collision.bounds = new WorldBounds(-5, -5, -5, 1, 5, 50);
                var a:Agent = agentAt("tetrahedron", 0, 0, 0.5);
                var b:Agent = agentAt("tetrahedron", 0.3, 0, 0.5);
                collision.onCollision("turtles", Collision.TERRAIN, ignore);
                collision.onCollision("turtles", Collision.EDGE, ignore);
                collision.update(new <Agent>[a, b]);
                model.pose(new <Number>[0, 0, -3, 4, 0, 0, 0, 4, 0, 0, 0, 4]);
                var fresh:HierarchicalCollider = new HierarchicalCollider(land);
                fresh.exact = isExact;
                for each (var other:Agent in [b, collision.terrain.agent, collision.bounds.agent])
                {
                    assertEquals(other + ", exact: " + isExact, fresh.contactOf(a, other).toString(), collider.contactOf(a, other).toString());
                }
            }
        }

        [Test]
        public function aFrameThatThrowsIsNoNextFrame():void
        {
            for each (var name:String in EachCollider.NAMES)
            {
                for (var round:int = 0; round < _rounds; round++)
                {
                    _isSwept = round % 2 == 1;
                    var collider:Collider = EachCollider.make(name, sGreatLand);
                    playFrames(collider, EachCollider.make(name, sGreatLand));
                    var all:Vector.<Agent> = _agents.concat();
                    var expected:Vector.<Number> = contactsOf(collider, all);
                    change("position", someOf(all));
                    change("heading", someOf(all));
                    assertThrows(ArgumentError, /twice/, collider.findCollisions, _agents.concat(new <Agent>[_agents[0]]));
                    assertThrows(ArgumentError, /nothing/, collider.findCollisions, _agents.concat(new <Agent>[new Agent("nothing")]));
                    compare(name + (_isSwept ? ", swept" : ""), expected, contactsOf(collider, all));
                }
            }
            _wrong.assertNone();
        }

        [Test]
        public function ofAgentsThatNoFrameHasSeenTheyAreThoseOfNow():void
        {
            for each (var name:String in EachCollider.NAMES)
            {
                var collider:Collider = EachCollider.make(name, sGreatLand);
                makeAgents(false);
                for (var round:int = 0; round < 4; round++)
                {
                    // twice: asked for the first time, and after moving on
                    compareWithNow(name, "before any frame", collider);
                    change("position", someOf(_agents));
                    change(_random.pick(["size", "shape", "pitch", "hierarchical", "collideAs"]), someOf(_agents));
                }
                var others:Vector.<Agent> = _agents;
                makeAgents(true);
                collider.findCollisions(_agents);
                _agents = others;
                for (round = 0; round < 4; round++)
                {
                    compareWithNow(name, "after a frame of others", collider);
                    change("position", someOf(_agents));
                    change(_random.pick(["size", "shape", "pitch", "hierarchical", "collideAs"]), someOf(_agents));
                }
            }
            assertEnough(0);
        }

        [Test]
        public function ofAgentsThatTheLastFrameDidNotSeeTheyAreThoseOfNow():void
        {
            for each (var name:String in EachCollider.NAMES)
            {
                for (var round:int = 0; round < _rounds; round++)
                {
                    _isSwept = round % 2 == 1;
                    var collider:Collider = EachCollider.make(name, sGreatLand);
                    playFrames(collider, EachCollider.make(name, sGreatLand));
                    var stayed:Vector.<Agent> = _random.chance() ? new Vector.<Agent>() : new <Agent>[new Agent("cube"), new Agent("sphere")];
                    if (stayed.length > 0)
                    {
                        stayed[0].sweeps = _isSwept;
                    }
                    collider.findCollisions(stayed);
                    compareWithNow(name, "left", collider);
                    change("position", someOf(_agents));
                    change("size", someOf(_agents));
                    compareWithNow(name, "left and moved", collider);
                    askAll(collider, _agents);
                    change("heading", someOf(_agents));
                    compareWithNow(name, "left and asked about", collider);
                }
            }
            assertEnough(0);
        }

        [Test]
        public function ofOneWhoseModelWasLoadingInTheLastFrameTheyAreThoseOfNow():void
        {
            for each (var name:String in EachCollider.NAMES)
            {
                for (var round:int = 0; round < _rounds; round++)
                {
                    var collider:Collider = EachCollider.make(name, sGreatLand);
                    makeAgents(false);
                    sGreatLand.expect("later");
                    _agents[2].shape = "later";
                    collider.findCollisions(_agents);
                    assertThrows(ArgumentError, _agents[2] + ": its model is still loading", collider.contactOf, _agents[1], _agents[2]);
                    assertThrows(ArgumentError, _agents[2] + ": its model is still loading", collider.contactOf, _agents[2], _agents[1]);
                    var cube:Model = BuiltInModel.cube();
                    sGreatLand.addModel(new Model("later", cube.vertices, cube.triangles));
                    sGreatLand.expectNoMore("later");
                    compareWithNow(name, "one that came", collider);
                    sGreatLand.removeModel("later");
                }
            }
            assertEnough(0);
        }

        // What agents do leaves the contacts of a frame as they were; with questions after it, and without.
        private function assertContactsStay(cause:String, happens:Function, makesADifference:Boolean = true):void
        {
            begin();
            for each (var name:String in EachCollider.NAMES)
            {
                for (var round:int = 0; round < _rounds; round++)
                {
                    _isSwept = round % 2 == 1;
                    var isAsking:Boolean = round % 4 >= 2;
                    if (sAreModelsSpoilt)
                    {
                        addModels();
                    }
                    var asked:Collider = EachCollider.make(name, sGreatLand);
                    var silent:Collider = EachCollider.make(name, sGreatLand);
                    playFrames(asked, silent);
                    var all:Vector.<Agent> = _agents.concat();
                    var expected:Vector.<Number> = contactsOf(asked, all);
                    happens(someOf(all));
                    if (isAsking)
                    {
                        assertTrue("no pairs", askAll(asked, all) >= COUNT && askAll(silent, all) >= COUNT);
                    }
                    var called:String = cause + ": " + name + (_isSwept ? ", swept" : ", standing") + (isAsking ? ", with questions" : "");
                    compare(called, expected, contactsOf(asked, all));
                    compare(called + ", asked late", expected, contactsOf(silent, all));
                    countDifferent(name, expected, all);
                }
            }
            assertEnough(makesADifference ? _compared / 100 : 0);
        }

        private function addModels(agents:Array = null):void
        {
            for each (var model:Model in [BuiltInModel.sphere(), BuiltInModel.cube(), BuiltInModel.cylinder(), SolidModels.apart(), SolidModels.wedge("plank", 0.3)])
            {
                sGreatLand.addModel(model);
            }
            sAreModelsSpoilt = false;
        }

        private static function addPlanks(agents:Array):void
        {
            for each (var shape:String in SHAPES)
            {
                sGreatLand.addModel(SolidModels.wedge(shape, 0.7));
            }
            sAreModelsSpoilt = true;
        }

        private static function removeModels(agents:Array):void
        {
            for each (var shape:String in SHAPES)
            {
                assertTrue(sGreatLand.removeModel(shape));
            }
            sAreModelsSpoilt = true;
        }

        private static function changeLibraries(agents:Array):void
        {
            var other:Model = SolidModels.wedge("plank", 0.7);
            for each (var shape:String in SHAPES)
            {
                sGreatLand.boundingStructures.add(shape, other.vertices);
                sGreatLand.hierarchies.add(shape, other.vertices, other.triangles);
            }
            sAreModelsSpoilt = true;
        }

        // One frame, or one and another in which some have moved and sweep.
        private function playFrames(collider:Collider, other:Collider):void
        {
            makeAgents(_isSwept);
            collider.findCollisions(_agents);
            other.findCollisions(_agents);
            if (_isSwept)
            {
                change("position", someOf(_agents));
                assertSamePairs("swept", other.findCollisions(_agents), collider.findCollisions(_agents));
            }
        }

        private function makeAgents(areSweeping:Boolean):void
        {
            _agents = new Vector.<Agent>();
            for (var i:int = 0; i < COUNT; i++)
            {
                var agent:Agent = new Agent(_random.pick(SHAPES), _random.pick(["bears", "balls"]));
                agent.moveTo(_random.between(-1, 1), _random.between(-1, 1), _random.between(-0.5, 0.5));
                agent.size = _random.logBetween(0.5, 2);
                agent.heading = _random.between(0, 360);
                agent.pitch = _random.pick([0, _random.between(0, 360)]);
                agent.roll = _random.pick([0, _random.between(0, 360)]);
                agent.hierarchical = _random.chance();
                agent.traversalDepth = _random.pick([0, 0, 2, 4]);
                agent.sweeps = areSweeping && (i == 0 || _random.chance());
                _agents.push(agent);
            }
        }

        private function change(trait:String, agents:*):void
        {
            for each (var agent:Agent in agents)
            {
                AgentChanges.change(trait, agent, SHAPES, _random);
            }
        }

        // One of them, two or all.
        private function someOf(agents:Vector.<Agent>):Array
        {
            var chosen:Array = [];
            var least:int = _random.pick([1, 2, agents.length]);
            var first:int = _random.integer(0, agents.length - 1);
            for (var i:int = 0; i < least; i++)
            {
                chosen.push(agents[(first + i) % agents.length]);
            }
            return chosen;
        }

        // Some of the models may be unknown by now, and no agent is a pair with itself.
        private static function askAll(collider:Collider, agents:Vector.<Agent>):int
        {
            var refused:int = 0;
            for (var i:int = 0; i < agents.length; i++)
            {
                for (var j:int = 0; j < agents.length; j++)
                {
                    try
                    {
                        collider.areColliding(agents[i], agents[j]);
                    }
                    catch (error:ArgumentError)
                    {
                        refused++;
                    }
                }
            }
            return refused;
        }

        // Eight numbers for each ordered pair; NaN where it throws.
        private static function contactsOf(collider:Collider, agents:Vector.<Agent>):Vector.<Number>
        {
            var numbers:Vector.<Number> = new Vector.<Number>();
            var contact:Contact = new Contact();
            for (var i:int = 0; i < agents.length; i++)
            {
                for (var j:int = 0; j < agents.length; j++)
                {
                    if (i == j)
                    {
                        continue;
                    }
                    try
                    {
                        collider.contactOf(agents[i], agents[j], contact);
                    }
                    catch (error:ArgumentError)
                    {
                        contact.time = NaN;
                    }
                    numbers.push(contact.time, contact.depth, contact.point.x, contact.point.y, contact.point.z, contact.normal.x,
                            contact.normal.y, contact.normal.z);
                }
            }
            return numbers;
        }

        // What a collider tells that has just seen the agents, each for the first time.
        private function compareWithNow(name:String, when:String, collider:Collider):void
        {
            var fresh:Collider = EachCollider.make(name, sGreatLand);
            fresh.findCollisions(_agents);
            compare(name + ", " + when, contactsOf(fresh, _agents), contactsOf(collider, _agents));
        }

        private function compare(name:String, expected:Vector.<Number>, actual:Vector.<Number>):void
        {
            assertEquals(name, expected.length, actual.length);
            for (var at:int = 0; at < expected.length; at += 8)
            {
                _compared++;
                _deep += expected[at + 1] > 0 ? 1 : 0;
                _passing += expected[at] > 0 && expected[at] < 1 ? 1 : 0;
                _wrong.addIf(!areNear(expected, actual, at), name, textAt(actual, at) + ", not " + textAt(expected, at));
            }
        }

        // time, depth, point, normal
        private static function textAt(numbers:Vector.<Number>, at:int):String
        {
            var parts:Array = [];
            for (var i:int = at; i < at + 8; i++)
            {
                parts.push(numbers[i].toFixed(3));
            }
            return "(" + parts.join(" ") + ")";
        }

        private static function areNear(expected:Vector.<Number>, actual:Vector.<Number>, at:int):Boolean
        {
            for (var i:int = at; i < at + 8; i++)
            {
                // false for NaN too
                if (!(Math.abs(expected[i] - actual[i]) <= NEAR))
                {
                    return false;
                }
            }
            return true;
        }

        // Where the agents are now they would touch otherwise.
        private function countDifferent(name:String, expected:Vector.<Number>, agents:Vector.<Agent>):void
        {
            var now:Vector.<Number> = contactsOf(EachCollider.make(name, sGreatLand), agents);
            for (var at:int = 0; at < now.length; at += 8)
            {
                _different += areNear(expected, now, at) ? 0 : 1;
            }
        }

        private function assertEnough(different:Number):void
        {
            trace("  " + _compared + " contacts, " + _deep + " with a depth, " + _passing + " within a motion");
            _wrong.assertNone();
            assertTrue(_compared + " contacts, " + _deep + " with a depth", _deep > _compared / 10);
            assertTrue(_passing + " within a motion", _passing > 0 || different == 0);
            assertTrue(_different + " other contacts now", _different >= different);
        }

        private static function assertSamePairs(name:String, expected:Vector.<Agent>, actual:Vector.<Agent>):void
        {
            assertEquals(name, textOf(expected), textOf(actual));
        }

        private static function textOf(pairs:Vector.<Agent>):String
        {
            var lines:Array = [];
            for (var i:int = 0; i < pairs.length; i += 2)
            {
                lines.push(pairs[i].id + "-" + pairs[i + 1].id);
            }
            return lines.sort().join(" ");
        }
    }
}
