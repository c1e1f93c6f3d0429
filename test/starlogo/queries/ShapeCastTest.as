package starlogo.queries
{
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertStrictlyEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Cylinder;
    import starlogo.bounding.Sphere;
    import starlogo.collision.Collider;
    import starlogo.collision.Contact;
    import starlogo.geometry.Placement;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import support.Complaints;
    import support.EachCollider;
    import support.Effort;
    import support.PlainDistance;
    import support.RandomWorlds;
    import support.SolidModels;
    import support.SurfaceDistance;
    import support.assertThrows;
    import support.landOf;

    /** Structures and agents that are cast along a way: against the motions of agents, and against small steps. */
    public class ShapeCastTest
    {
        private static const SHAPES:Array = ["sphere", "cube", "cylinder", "plank", "hollow", "apart"];
        private static const NEAR:Number = 1e-8;

        private static var sGreatLand:GreatLand;

        private var _random:SeededRandom = new SeededRandom(3805);
        private var _structures:RandomStructures = new RandomStructures(_random);
        private var _wrong:Complaints = new Complaints();

        [BeforeClass]
        public static function makeModels():void
        {
            sGreatLand = landOf(SolidModels.all(), BuiltInModel.cylinder(), SolidModels.plank());
        }

        private static const SAME:Number = 1e-9;

        // What only grazes is not stopped, as in moveUntilTouch(); a frame of sweeps reports it.
        [Test]
        public function theEndOfASegmentGrazesAnEdge():void
        {
            sGreatLand.addModel(new Model("edge", new <Number>[-1, 1, -1, -1, 1, 1], new <uint>[0, 1, 1], Model.AS_GIVEN));
            sGreatLand.addModel(new Model("rod", new <Number>[-1, -1, 0, 1, -1, 0], new <uint>[0, 1, 1], Model.AS_GIVEN));
            var collider:Collider = EachCollider.make("triangles", sGreatLand);
            var edge:Agent = new Agent("edge");
            var queries:AgentQueries = new AgentQueries(collider);
            queries.update(new <Agent>[edge]);
            assertNull("grazes", queries.castShape(new Capsule(new Vector3D(-1, -1), new Vector3D(1, -1), 0), 0, 4, 0));
            var hit:ShapeHit = queries.castShape(new Capsule(new Vector3D(-1.0001, -1), new Vector3D(1, -1), 0), 0, 4, 0);
            assertTrue("meets at " + hit.time, Math.abs(hit.time - 0.5) < SAME);
            var rod:Agent = new Agent("rod");
            rod.sweeps = true;
            collider.findCollisions(new <Agent>[edge, rod]);
            rod.y = 4;
            assertEquals("a frame", 2, collider.findCollisions(new <Agent>[edge, rod]).length);
        }

        // A body that is thinner than a cast's clearance is above a sheet, and does not touch it. More than half of it is through the sheet where it first
        // touches the sheet, up to half of a clearance beside its place.
        [Test]
        public function aThinBoxCloseToASheetDoesNotPassIt():void
        {
            for each (var half:Number in [1, 50, 500])
            {
                var queries:AgentQueries = new AgentQueries(EachCollider.make("triangles", landOf(sheet("sheet", half))));
                queries.update(new <Agent>[new Agent("sheet")]);
                for (var thickness:Number = 1e-12; thickness < 1e-7; thickness *= 1.5)
                {
                    for (var gap:Number = half * 1e-12; gap < 1e-8; gap *= 2)
                    {
                        for each (var side:int in [1, -1])
                        {
                            var box:Box = new Box(new Vector3D(0.1, 0.2, side * (gap + thickness / 2)), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0.5, 0.5,
                                    thickness / 2);
                            var hit:ShapeHit = queries.castShape(box, 0, 0, -side);
                            _wrong.addIf(hit == null || hit.time < 0.5 * gap || hit.time > 1.1 * gap + 1e-15, thickness + " thick, " + side * gap + " above " + 2 * half, String(hit));
                        }
                    }
                }
            }
            _wrong.assertNone();
        }

        private static function sheet(name:String, half:Number):Model
        {
            return new Model(name, new <Number>[-half, -half, 0, half, -half, 0, half, half, 0, -half, half, 0], new <uint>[0, 1, 2, 0, 2, 3], Model.AS_GIVEN);
        }

        [Test]
        public function aTriangleWithoutAreaIsMetOnIt():void
        {
            var met:int = 0;
            for (var i:int = 0; i < Effort.choose(300, 10000); i++)
            {
                var start:Vector3D = _structures.position(1);
                var end:Vector3D = _structures.position(1);
                var share:Number = i % 3 == 0 ? 0 : _random.next();
                var middle:Vector3D = new Vector3D(start.x + share * (end.x - start.x), start.y + share * (end.y - start.y), start.z + share * (end.z - start.z));
                var vertices:Vector.<Number> = new <Number>[start.x, start.y, start.z, middle.x, middle.y, middle.z, end.x, end.y, end.z];
                sGreatLand.addModel(new Model("line", vertices, new <uint>[0, 1, 2], Model.AS_GIVEN));
                var queries:AgentQueries = new AgentQueries(EachCollider.make("triangles", sGreatLand));
                queries.update(new <Agent>[new Agent("line")]);
                var box:Box = new Box(new Vector3D(-10), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, _random.next(), 2 * _random.next(), _random.next());
                var hit:ShapeHit = queries.castShape(box, 20, 0, 0);
                if (hit != null)
                {
                    met++;
                    var at:Vector.<Number> = new <Number>[hit.point.x, hit.point.y, hit.point.z, hit.point.x, hit.point.y, hit.point.z, hit.point.x, hit.point.y, hit.point.z];
                    var gap:Number = PlainDistance.ofTriangles(at, 0, vertices, 0);
                    assertTrue(i + ": " + gap + " beside " + start + " to " + end, gap < NEAR);
                }
            }
            sGreatLand.removeModel("line");
            assertTrue("met: " + met, met > Effort.choose(100, 3000));
        }

        [Test]
        public function agentsAreCastAsTheyMove():void
        {
            var stopped:int = 0;
            var free:int = 0;
            var several:int = 0;
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                var queries:AgentQueries = new AgentQueries(EachCollider.make(name, sGreatLand));
                var hits:Vector.<ShapeHit> = new Vector.<ShapeHit>();
                for (var i:int = Effort.choose(60, 5000); i > 0; i--)
                {
                    // half of the worlds begin with overlaps
                    var agents:Vector.<Agent> = RandomWorlds.mixed(8, SHAPES, i % 2 == 0 ? 1.5 : 4, _random);
                    queries.update(i % 3 == 0 ? agents.slice(1) : agents);
                    var agent:Agent = agents[0];
                    var way:Vector3D = anyWay(5);
                    var before:String = traitsOf(agent);
                    var hit:ShapeHit = queries.castAgent(agent, way.x, way.y, way.z);
                    queries.castAgentAll(agent, way.x, way.y, way.z, null, hits);
                    assertEquals(name + ": nothing moves", before, traitsOf(agent));
                    assertHitsAreThoseOfEach(name, queries, agents, way, hits);
                    several += hits.length > 1 ? 1 : 0;
                    var contact:Contact = new Contact();
                    var part:Number = queries.moveUntilTouch(agent, way.x, way.y, way.z, null, contact);
                    if (hit == null)
                    {
                        free++;
                        assertEquals(name + ": free", 1, part);
                        assertEquals(name + ": none", 0, hits.length);
                        continue;
                    }
                    stopped++;
                    // the cast is of a structure, whose place is rounded otherwise than the agent's
                    assertTrue(name + ": time", Math.abs(part - hit.time) < SAME);
                    assertTrue(name + ": normal", Vector3D.distance(hit.normal, contact.normal) < SAME);
                    assertTrue(name + ": approach", Math.abs(contact.approachSpeed + Math.min(0, way.dotProduct(contact.normal))) < 1e-12);
                    assertEquals(name + ": the first of all", hits[0].time, hit.time);
                    assertStrictlyEquals(name + ": the first of all", hits[0].agent, hit.agent);
                }
            }
            assertTrue(stopped + " stopped, " + free + " free, " + several, stopped > 100 && free > 60 && several > 60);
        }

        [Test]
        public function structuresGoAsFarAsNothingOverlaps():void
        {
            var stopped:int = 0;
            var free:int = 0;
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                var queries:AgentQueries = new AgentQueries(EachCollider.make(name, sGreatLand));
                var found:Vector.<Agent> = new Vector.<Agent>();
                for (var i:int = Effort.choose(90, 6000); i > 0; i--)
                {
                    queries.update(RandomWorlds.mixed(9, SHAPES, 2.5, _random));
                    var structure:BoundingStructure = _structures.ofKind(i % 3, _random.logBetween(0.05, 1), 4);
                    var way:Vector3D = anyWay(5);
                    if (queries.overlapping(structure, null, found).length > 0)
                    {
                        continue;
                    }
                    var was:String = structure.toString();
                    var hit:ShapeHit = queries.castShape(structure, way.x, way.y, way.z);
                    assertEquals(name + ": not changed", was, structure.toString());
                    var most:Number = hit == null ? 1 : hit.time;
                    for (var k:int = 0; k <= 40; k++)
                    {
                        var share:Number = most * (1 - 1e-7) * k / 40;
                        if (queries.overlapping(moved(structure, way, share), null, found).length > 0)
                        {
                            _wrong.add(name + ": goes through", structure + " along " + way + ", at " + share + " of " + most);
                            break;
                        }
                    }
                    if (hit == null)
                    {
                        free++;
                        continue;
                    }
                    stopped++;
                    assertHit(name, queries, structure, way, hit);
                }
            }
            _wrong.assertNone();
            assertTrue(stopped + " stopped, " + free + " free", stopped > 50 && free > 60);
        }

        [Test]
        public function anAgentAndItsStructureAreCastTheSameToTheBit():void
        {
            var stopped:int = 0;
            for each (var name:String in ["tightest fits", "combinations, exact"])
            {
                var queries:AgentQueries = new AgentQueries(EachCollider.make(name, sGreatLand));
                for (var i:int = Effort.choose(200, 10000); i > 0; i--)
                {
                    var agents:Vector.<Agent> = RandomWorlds.mixed(6, SHAPES, 3, _random);
                    for (var k:int = 0; k < agents.length; k++)
                    {
                        agents[k].hierarchical = k > 0 && i % 2 == 0;
                    }
                    queries.update(agents);
                    var fit:BoundingStructure = sGreatLand.boundingStructures.tightestFit(agents[0].shape);
                    var filter:AgentFilter = new AgentFilter();
                    filter.except = new <Agent>[agents[0]];
                    var way:Vector3D = anyWay(5);
                    var expected:ShapeHit = queries.castAgent(agents[0], way.x, way.y, way.z);
                    var hit:ShapeHit = queries.castShape(fit.place(placementOf(agents[0])), way.x, way.y, way.z, filter);
                    assertEquals(expected == null, hit == null);
                    if (hit != null)
                    {
                        stopped++;
                        assertEquals([expected.time, expected.point, expected.normal].join(), [hit.time, hit.point, hit.normal].join());
                        assertStrictlyEquals(expected.agent, hit.agent);
                    }
                }
            }
            assertTrue(String(stopped), stopped > 12);
        }

        private static function placementOf(agent:Agent):Placement
        {
            var placement:Placement = new Placement();
            placement.setRotation(agent.heading, agent.pitch, agent.roll);
            placement.size = agent.size;
            placement.x = agent.x;
            placement.y = agent.y;
            placement.z = agent.z;
            return placement;
        }

        [Test]
        public function whatIsTouchedAtTheBeginning():void
        {
            for each (var name:String in EachCollider.NAMES.slice(1))
            {
                var queries:AgentQueries = new AgentQueries(EachCollider.make(name, sGreatLand));
                var cube:Agent = new Agent("cube");
                queries.update(new <Agent>[cube]);
                for each (var structure:BoundingStructure in [new Sphere(new Vector3D(0.2, 0, 1.5), 0.5),
                            new Capsule(new Vector3D(-0.2, 0, 1.5), new Vector3D(0.2, 0.1, 1.5), 0.5),
                            new Box(new Vector3D(0.1, 0, 1.5), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0.5, 0.5, 0.5)])
                {
                    var message:String = name + ", " + structure;
                    var into:ShapeHit = queries.castShape(structure, 0.3, 0, -1);
                    assertTrue(message, into != null && into.time < NEAR && into.agent == cube && into.normal.z > 1 - NEAR);
                    assertNull(message, queries.castShape(structure, 0, 0, 1));
                    assertNull(message, queries.castShape(structure, 2, 1, 0));
                    assertNull(message, queries.castShape(structure, 0, 0, 0));
                    structure.translate(new Vector3D(0, 0, -0.3));
                    into = queries.castShape(structure, 0, 0, -1);
                    assertTrue(message, into.time == 0 && into.agent == cube && into.normal.z > 1 - NEAR);
                    assertNull(message, queries.castShape(structure, 0, 0, 1));
                    assertEquals(message, 1, queries.castShapeAll(structure, 0, 0, -1).length);
                    assertEquals(message, 0, queries.castShapeAll(structure, 0, 0, 0).length);
                }
            }
        }

        [Test]
        public function filtersAndQuestionsOfTheirOwn():void
        {
            for each (var name:String in EachCollider.NAMES)
            {
                var queries:AgentQueries = new AgentQueries(EachCollider.make(name, sGreatLand));
                var agents:Vector.<Agent> = new <Agent>[cubeAt(0, "movers"), cubeAt(3, "ghosts"), cubeAt(6, "walls"), cubeAt(9, "walls")];
                queries.update(agents);
                var ball:Sphere = new Sphere(new Vector3D(-3, 0, 0.5), 0.25);
                var filter:AgentFilter = new AgentFilter();
                var small:Agent = new Agent("sphere");
                small.size = 0.01;
                filter.exceptBreeds = new <String>["ghosts"];
                assertStrictlyEquals(name, agents[2], queries.castAgent(agents[0], 20, 0, 0, filter).agent);
                assertStrictlyEquals(name, agents[0], queries.castShape(ball, 20, 0, 0).agent);
                filter.accepts = function(agent:Agent):Boolean
                {
                    // questions of its own: of another structure, of another agent that is in the list, and of a small one that is not
                    queries.castShape(new Sphere(new Vector3D(0, 0, 40), 1), 0, 1, 0);
                    queries.castAgent(agents[3], -20, 0, 0);
                    queries.castAgent(small, 1, 0, 0);
                    queries.overlapping(new Sphere(new Vector3D(3, 3, 3), 0.01));
                    queries.distanceToPoint(agent, new Vector3D(1, 2, 3));
                    queries.wouldTouchAt(small, 5, 5, 5);
                    return agent.x > 7;
                };
                assertStrictlyEquals(name, agents[3], queries.castShape(ball, 20, 0, 0, filter).agent);
                var hit:ShapeHit = queries.castAgent(agents[0], 20, 0, 0, filter);
                assertStrictlyEquals(name, agents[3], hit.agent);
                assertTrue(name + ": as long as it is", Math.abs(hit.time - 0.4) < 0.01);
                assertTrue(name, Math.abs(queries.moveUntilTouch(agents[0], 20, 0, 0, filter) - hit.time) < SAME);
                agents[0].moveTo(0, 0, 0);
                queries.moved(agents[0]);
                hit = new ShapeHit();
                assertStrictlyEquals(name, hit, queries.castAgent(agents[0], 20, 0, 0, null, hit));
                assertStrictlyEquals(name, agents[1], hit.agent);
                assertNull(name, queries.castAgent(agents[0], 1, 0, 0, null, hit));
                assertStrictlyEquals(name, agents[1], hit.agent);
                var hits:Vector.<ShapeHit> = queries.castShapeAll(ball, 20, 0, 0);
                assertEquals(name, 4, hits.length);
                hit = hits[0];
                assertStrictlyEquals(name, hits, queries.castShapeAll(ball, 7, 0, 0, null, hits));
                assertEquals(name, 2, hits.length);
                assertStrictlyEquals(name, hit, hits[0]);
                assertTrue(name, hits[0].agent == agents[0] && hits[1].agent == agents[1] && hits[0].time < hits[1].time);
            }
        }

        [Test]
        public function whatIsRefusedChangesNothing():void
        {
            var queries:AgentQueries = new AgentQueries(EachCollider.make("triangles", sGreatLand));
            var agents:Vector.<Agent> = new <Agent>[cubeAt(0, "a"), cubeAt(3, "b")];
            queries.update(agents);
            var ball:Sphere = new Sphere(new Vector3D(), 1);
            assertThrows(ArgumentError, /structure|sphere, box, capsule or hull.*null/, queries.castShape, null, 1, 0, 0);
            assertThrows(ArgumentError, /Cylinder/, queries.castShapeAll, new Cylinder(new Vector3D(), new Vector3D(0, 0, 1), 1), 1, 0, 0);
            assertThrows(RangeError, /NaN/, queries.castShape, ball, NaN, 0, 0);
            assertThrows(RangeError, /Infinity/, queries.castAgent, agents[0], 0, Infinity, 0);
            assertThrows(ArgumentError, /null/, queries.castAgent, null, 1, 0, 0);
            assertThrows(ArgumentError, /unicorn/, queries.castAgent, new Agent("unicorn"), 1, 0, 0);
            ball.radius = Infinity;
            assertThrows(RangeError, /finite/, queries.castShape, ball, 1, 0, 0);
            assertThrows(RangeError, /NaN/, queries.overlapsAgent, agents[0], 0, NaN, 0);
            assertThrows(ArgumentError, /null/, queries.overlapsAgent, null, 0, 0, 0);
            assertTrue(Math.abs(queries.castAgent(agents[0], 4, 0, 0).time - 0.5) < NEAR);
        }

        [Test]
        public function agentsOverlapWhatTheyWouldTouch():void
        {
            var touches:int = 0;
            var misses:int = 0;
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                var collider:Collider = EachCollider.make(name, sGreatLand);
                var queries:AgentQueries = new AgentQueries(collider);
                for (var i:int = Effort.choose(60, 5000); i > 0; i--)
                {
                    var agents:Vector.<Agent> = RandomWorlds.mixed(4, SHAPES, 2, _random);
                    queries.update(i % 3 == 0 ? agents.slice(1) : agents);
                    var agent:Agent = agents[0];
                    var before:String = traitsOf(agent);
                    var to:Vector3D = anyWay(2);
                    var overlaps:Boolean = queries.overlapsAgent(agent, to.x, to.y, to.z);
                    var touching:Boolean = queries.touchesAny(agent);
                    assertEquals(name + ": does not move", before, traitsOf(agent));
                    assertEquals(name + ": where it is", touching, queries.overlapsAgent(agent, agent.x, agent.y, agent.z));
                    agent.moveTo(to.x, to.y, to.z);
                    assertEquals(name + " " + i, overlaps, queries.touchesAny(agent));
                    overlaps ? touches++ : misses++;
                    var filter:AgentFilter = new AgentFilter();
                    filter.accepts = function(other:Agent):Boolean
                    {
                        return !collider.areColliding(agent, other);
                    };
                    assertFalse(name + ": none is accepted", queries.overlapsAgent(agent, to.x, to.y, to.z, filter));
                }
            }
            assertTrue(touches + " touch, " + misses + " do not", touches > 50 && misses > 50);
        }

        // Each agent of the list is hit as it is when it is the only one that counts, in the order of times and of the list.
        private function assertHitsAreThoseOfEach(name:String, queries:AgentQueries, agents:Vector.<Agent>, way:Vector3D, hits:Vector.<ShapeHit>):void
        {
            var agent:Agent = agents[0];
            for (var i:int = 0; i < hits.length; i++)
            {
                var filter:AgentFilter = new AgentFilter();
                filter.accepts = function(other:Agent):Boolean
                {
                    return other == hits[i].agent;
                };
                var single:ShapeHit = queries.castAgent(agent, way.x, way.y, way.z, filter);
                assertEquals(name + ": alone", single.time, hits[i].time);
                assertTrue(name + ": alone", single.normal.equals(hits[i].normal) && single.point.equals(hits[i].point));
                assertTrue(name + ": sorted", i == 0 || hits[i - 1].time < hits[i].time
                        || hits[i - 1].time == hits[i].time && agents.indexOf(hits[i - 1].agent) < agents.indexOf(hits[i].agent));
                assertTrue(name + ": not itself", hits[i].agent != agent);
            }
        }

        private function assertHit(name:String, queries:AgentQueries, structure:BoundingStructure, way:Vector3D, hit:ShapeHit):void
        {
            var message:String = structure + " along " + way + " at " + hit.time + ", normal " + hit.normal + ", point " + hit.point + ", " + hit.agent;
            _wrong.addIf(Math.abs(hit.normal.length - 1) > 1e-12 || !(hit.normal.dotProduct(way) < 0), name + ": normal", message);
            var there:BoundingStructure = moved(structure, way, hit.time);
            var surface:Number = SurfaceDistance.of(there, hit.point);
            _wrong.addIf(!(surface < NEAR) || !(queries.distanceToPoint(hit.agent, hit.point) < NEAR),
                    name + ": point", surface + ", " + queries.distanceToPoint(hit.agent, hit.point) + ": " + message);
            var deeper:BoundingStructure = moved(there, hit.normal, -1e-7);
            _wrong.addIf(queries.overlapping(deeper).indexOf(hit.agent) < 0, name + ": no touch", message);
            var apart:BoundingStructure = moved(there, hit.normal, 1e-7);
            _wrong.addIf(queries.overlapping(apart).indexOf(hit.agent) >= 0, name + ": normal does not separate", message);
        }

        private static function moved(structure:BoundingStructure, way:Vector3D, share:Number):BoundingStructure
        {
            return structure.clone().translate(new Vector3D(share * way.x, share * way.y, share * way.z));
        }

        private static function traitsOf(agent:Agent):String
        {
            return [agent.x, agent.y, agent.z, agent.heading, agent.pitch, agent.roll, agent.size].join();
        }

        private static function cubeAt(x:Number, breed:String):Agent
        {
            var agent:Agent = new Agent("cube", breed);
            agent.x = x;
            return agent;
        }

        private function anyWay(most:Number):Vector3D
        {
            return new Vector3D(_random.between(-most, most), _random.between(-most, most), _random.between(-most, most));
        }
    }
}
