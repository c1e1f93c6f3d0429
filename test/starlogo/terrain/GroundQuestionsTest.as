package starlogo.terrain
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertStrictlyEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.Sphere;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collider;
    import starlogo.collision.Collision;
    import starlogo.collision.Contact;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.queries.AgentFilter;
    import starlogo.queries.AgentQueries;
    import starlogo.queries.RayHit;
    import starlogo.queries.ShapeHit;
    import starlogo.queries.WalkOptions;
    import support.AgentPieces;
    import support.EachCollider;
    import support.Effort;
    import support.FrameByFrame;
    import support.GroundReference;
    import support.PlainDistance;
    import support.RandomGround;
    import support.SolidModels;
    import support.agentAt;
    import support.assertThrows;
    import support.fillHeights;
    import support.landOf;

    /** Questions about the ground: rays, sight, touches, distances and motions. */
    public class GroundQuestionsTest
    {
        private var _models:Object = {cube: BuiltInModel.cube(), sphere: BuiltInModel.sphere(), beam: beam()};
        private var _land:GreatLand;
        private var _random:SeededRandom;

        // The ground under way.
        private var _kind:String;
        private var _terrain:Terrain;
        private var _reference:GroundReference;

        [Before]
        public function makeLand():void
        {
            _land = landOf(_models.cube, _models.sphere, _models.beam, new Model("plate", new <Number>[-0.5, -0.5, 0, 0.5, -0.5, 0, 0.5, 0.5, 0, -0.5, 0.5, 0], new <uint>[0, 1, 2, 0, 2, 3]));
            _random = new SeededRandom(39);
        }

        [Test(async, timeout="3600000")]
        public function raysAreLikeEveryTriangle():void
        {
            var hits:int = 0;
            var count:int = Effort.choose(2000, 100000, 320);
            var queries:AgentQueries = new AgentQueries(new BinCollider());
            FrameByFrame.repeat(this, count, function(i:int):void
                {
                    if (i % 20 == 0)
                    {
                        makeGround(i / 20);
                        queries.terrain = _terrain;
                        queries.update(new <Agent>[]);
                    }
                    var origin:Vector3D = placeAbout(1);
                    var direction:Vector3D = placeAbout(0.5).subtract(origin);
                    if (_random.chance(0.2))
                    {
                        direction[_random.pick(["x", "y", "z"])] = 0;
                    }
                    direction.normalize();
                    hits += checkRay(queries, origin, direction, _kind + " " + i);
                }, function():void
                {
                    assertTrue("hits: " + hits, hits > 0.3 * count && hits < 0.95 * count);
                });
        }

        // Rounding far from the origin must not leave out the cells beyond a corner.
        [Test]
        public function raysThroughCornersFarOutMeetTheColumns():void
        {
            var queries:AgentQueries = new AgentQueries(new BinCollider());
            for each (var far:Number in [0, 1e5, -1e6])
            {
                for (var i:int = 0; i < 100; i++)
                {
                    var width:Number = _random.between(0.1, 1);
                    var terrain:Terrain = new Terrain(8, 8, width, far, far);
                    terrain.isBlocky = true;
                    for (var column:int = 0; column < 8; column++)
                    {
                        terrain.setHeight(column, 4, 9 * width);
                    }
                    queries.terrain = terrain;
                    queries.update(new <Agent>[]);
                    // from the middle of a column over its corner, half a cell farther, and on
                    var from:Vector3D = new Vector3D(far + 2 * width, far + 3 * width, 5 * width);
                    var way:Vector3D = new Vector3D(far + 5 * width, far + 6 * width, 2 * width).subtract(from);
                    var hit:RayHit = queries.cast(from, way, way.length);
                    assertTrue(far + ", " + width + ": " + hit, hit != null && Math.abs(hit.point.z - 4.5 * width) < 1e-8);
                }
            }
        }

        [Test(async, timeout="3600000")]
        public function distancesAreLikeEveryTriangle():void
        {
            var touching:int = 0;
            var count:int = Effort.choose(40, 10000, 8);
            FrameByFrame.repeat(this, count, function(i:int):void
                {
                    makeGround(i);
                    for each (var name:String in EachCollider.NAMES)
                    {
                        var agent:Agent = agentAbout();
                        agent.z += i % 5 == 4 ? 40 * _terrain.cellWidth : -(i % 3) * agent.size;
                        touching += checkDistance(name, agent, _kind + " " + i + ", " + name + ": ");
                    }
                }, function():void
                {
                    assertTrue("touching: " + touching, touching > count / 4 && touching < 4 * count);
                });
        }

        // Returns 1 if the agent touches the ground.
        private function checkDistance(name:String, agent:Agent, what:String):int
        {
            var collider:Collider = EachCollider.make(name, _land);
            var queries:AgentQueries = new AgentQueries(collider);
            var a:Vector3D = new Vector3D();
            var b:Vector3D = new Vector3D();
            var distance:Number = queries.distance(agent, _terrain.agent, a, b);
            var expected:Number = Math.max(0, _reference.gapOf(piecesOf(name, agent)));
            var near:Number = 1e-9 * (agent.size + _terrain.cellWidth + expected) + 1e-11 * (Math.abs(_terrain.x) + 1000);
            what += distance + " instead of " + expected;
            assertTrue(what, Math.abs(distance - expected) < near);
            assertEquals(what + ", touches", distance == 0, collider.areColliding(agent, _terrain.agent));
            assertTrue(what + ", points", Math.abs(Vector3D.distance(a, b) - distance) < near);
            assertTrue(what + ", a point of the ground " + b, _terrain.heightAt(b.x, b.y) >= b.z || distanceOf(b) < near);
            assertTrue(what + ", a point of the agent " + a, queries.distanceToPoint(agent, a) < near);
            assertEquals(distance, queries.distance(_terrain.agent, agent, b, a));
            var under:Vector3D = new Vector3D(agent.x, agent.y, agent.z);
            if (_terrain.heightAt(under.x, under.y) >= under.z)
            {
                assertEquals(0, queries.distanceToPoint(_terrain.agent, under, a));
                assertTrue(what + ", the point itself", a.equals(under));
            }
            return distance > near ? 0 : 1;
        }

        // The last height of this ground is a rounding error beyond its last cell.
        [Test]
        public function agentsBeyondTheLastHeightHaveADistance():void
        {
            var terrain:Terrain = new Terrain(8, 11, 1.654518056244867, -6.618072224979468, -9.099849309346768);
            var end:Number = terrain.y + 10 * terrain.cellWidth;
            assertTrue((end - terrain.y) / terrain.cellWidth > 10);
            for each (var name:String in EachCollider.NAMES)
            {
                var agent:Agent = agentAt("cube", 0, end + 2, 1);
                agent.hierarchical = true;
                var distance:Number = new AgentQueries(EachCollider.make(name, _land)).distance(agent, terrain.agent);
                assertTrue(name + ": " + distance, distance > 1 && distance < 2 + 1e-12);
            }
        }

        [Test(async, timeout="3600000")]
        public function motionsEndInTheFirstTouch():void
        {
            var stopped:int = 0;
            var count:int = Effort.choose(16, 10000, 8);
            FrameByFrame.repeat(this, count, function(i:int):void
                {
                    makeGround(i);
                    for each (var name:String in EachCollider.NAMES)
                    {
                        stopped += checkMotion(name, agentAbout(), _kind + " " + i + ", " + name + ": ");
                    }
                }, function():void
                {
                    assertTrue(stopped + " stopped", stopped > count);
                });
        }

        // Returns 1 if the ground stops the agent.
        private function checkMotion(name:String, agent:Agent, what:String):int
        {
            var pieces:Array = piecesOf(name, agent);
            var near:Number = 1e-8 * (agent.size + _terrain.cellWidth) + 1e-12 * (Math.abs(_terrain.x) + 1000);
            if (_reference.gapOf(pieces, 0, 0, 0, 2 * near) <= near)
            {
                return 0;
            }
            var queries:AgentQueries = new AgentQueries(EachCollider.make(name, _land));
            queries.terrain = _terrain;
            queries.update(new <Agent>[agent]);
            var motion:Vector3D = placeAbout(0.5).subtract(new Vector3D(agent.x, agent.y, agent.z));
            var expected:Number = Math.min(1, _reference.timeOf(pieces, motion, near / 1e4));
            var hit:ShapeHit = queries.castAgent(agent, motion.x, motion.y, motion.z);
            var part:Number = queries.moveUntilTouch(agent, motion.x, motion.y, motion.z);
            // far out the places themselves are that coarse
            var coarse:Number = 1e-9 + 1e-14 * Math.abs(_terrain.x) / motion.length;
            assertTrue(what + "as it is cast", Math.abs((hit == null ? 1 : hit.time) - part) < coarse);
            // if the agent grazes the ground, the reference may come nearer and nearer to it
            if (!isNaN(expected))
            {
                what += part + " instead of " + expected;
                assertTrue(what, part <= expected + near / motion.length);
                if (part < expected - 1e4 * near / motion.length)
                {
                    // it may have grazed something
                    assertTrue(what, _reference.gapOf(pieces, part * motion.x, part * motion.y, part * motion.z, 2 * near) < near);
                }
                slideOn(queries, agent, name, what);
            }
            return part < 1 ? 1 : 0;
        }

        // Along the ground in any direction: it gets somewhere, and not into the ground.
        private function slideOn(queries:AgentQueries, agent:Agent, name:String, what:String):void
        {
            for (var i:int = 0; i < 3; i++)
            {
                var far:Number = _terrain.cellWidth;
                queries.slide(agent, _random.normal() * far, _random.normal() * far, _random.normal() * far);
                var gap:Number = _reference.gapOf(shrunk(piecesOf(name, agent)), 0, 0, 0, far);
                assertTrue(what + ", slide " + i + ", gap " + gap, gap > 0);
            }
        }

        // Each piece a little smaller, about its middle. A piece that only touches the ground is then free of it, on whichever side it touches.
        private static function shrunk(pieces:Array):Array
        {
            for each (var piece:Object in pieces)
            {
                var points:Vector.<Number> = piece.points;
                var sums:Array = [0, 0, 0];
                for (var i:int = 0; i < points.length; i++)
                {
                    sums[i % 3] += points[i];
                }
                for (i = 0; i < points.length; i++)
                {
                    points[i] += (3 * sums[i % 3] / points.length - points[i]) * 1e-5;
                }
                piece.radius *= 1 - 1e-5;
            }
            return pieces;
        }

        [Test]
        public function fallsAlongABorderEndInATouchOrNotAtAll():void
        {
            var stopped:int = 0;
            var queries:AgentQueries = new AgentQueries(new BinCollider(_land));
            for (var i:int = 0; i < 400; i++)
            {
                var base:Number = [1e5, 1e6, -1e6, 3e5][i % 4];
                var terrain:Terrain = new Terrain(3, 3, 1, 0.1, 0);
                fillHeights(terrain, function(column:int, row:int):Number
                    {
                        return base + _random.between(-1, 1);
                    });
                queries.terrain = terrain;
                queries.update(new <Agent>[]);
                var agent:Agent = agentAt("cube", terrain.x - 0.5, _random.between(0.5, 1.5), base + 3);
                if (queries.moveUntilTouch(agent, i % 3 == 0 ? 0 : _random.between(-1e-3, 1e-3), _random.between(-1, 1), -5) < 1)
                {
                    stopped++;
                    assertTrue(i + " touches", queries.touchesAny(agent));
                }
            }
            assertTrue("stopped: " + stopped, stopped > 40 && stopped < 300);
        }

        // The one ground is the floor and both walls. What hides one of them lets the agent through.
        [Test]
        public function whatOverlapsTheSidesOfACornerALittleStaysOutsideOfAll():void
        {
            var stopped:int = 0;
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                for (var i:int = 0; i < Effort.choose(150, 1500, 30); i++)
                {
                    var base:Number = i % 5 == 0 ? 100 : 0;
                    var wall:Number = _random.pick([0.5, 1, 3]);
                    var terrain:Terrain = new Terrain(9, 9, 1, base, base);
                    terrain.isBlocky = true;
                    fillHeights(terrain, function(column:int, row:int):Number
                        {
                            return column == 5 || row == 5 ? wall : 0;
                        });
                    var queries:AgentQueries = new AgentQueries(EachCollider.make(name, _land));
                    queries.terrain = terrain;
                    queries.update(new <Agent>[]);
                    var agent:Agent = new Agent(i % 2 == 0 || name == "bins" ? "cube" : "plate");
                    agent.size = _random.pick([0.2, 0.6, 1]);
                    agent.heading = 90 * (i % 4);
                    var half:Number = agent.size / 2;
                    agent.moveTo(base + 4.5 - half + aLittle(agent.size), base + 4.5 - half + aLittle(agent.size), -aLittle(agent.size));
                    var dx:Number = _random.pick([0, 0.3, _random.between(-0.5, 0.5)]);
                    var dy:Number = _random.pick([0, 0.3, _random.between(-0.5, 0.5)]);
                    var dz:Number = _random.pick([0, -1, _random.between(-1, 0)]);
                    stopped += i % 3 == 0 && queries.moveUntilTouch(agent, dx, dy, dz) < 1 ? 1 : 0;
                    stopped += i % 3 == 1 && queries.slide(agent, dx, dy, dz) < 1 ? 1 : 0;
                    stopped += i % 3 == 2 && queries.walk(agent, dx, dy).part < 1 ? 1 : 0;
                    var message:String = [name, i, agent.x, agent.y, agent.z, dx, dy, dz].join(" ");
                    var deepest:Number = 2e-6 * agent.size;
                    assertTrue(message, agent.z > -deepest);
                    assertTrue(message, agent.z > wall - deepest || Math.max(agent.x, agent.y) + half < base + 4.5 + deepest);
                }
            }
            assertTrue("stopped: " + stopped, stopped > 60);
        }

        // An overlap from none to half of the largest that counts as a touch.
        private function aLittle(size:Number):Number
        {
            return _random.pick([0, 1e-13, 1e-12, 1e-10, 1e-8, 5e-7]) * size;
        }

        [Test]
        public function nothingSticksAtTheSeamsOfCells():void
        {
            var steps:int = Effort.choose(12, 200, 3);
            for each (var name:String in EachCollider.NAMES)
            {
                for (var i:int = 0; i < 12; i++)
                {
                    var terrain:Terrain = new Terrain(101, 11, 1, -10, -5);
                    var slope:Number = i % 3 == 2 ? 0.1 : 0;
                    fillHeights(terrain, function(column:int, row:int):Number
                        {
                            return slope * column;
                        });
                    terrain.isBlocky = i % 3 == 1;
                    var agent:Agent = new Agent(i % 2 == 0 ? "cube" : "sphere");
                    agent.heading = i % 4 < 2 ? 0 : _random.between(0, 360);
                    agent.moveTo(i % 4 == 1 ? 0 : _random.between(0, 1), _random.integer(-4, 4) / 2, slope * 10 + 2);
                    var queries:AgentQueries = new AgentQueries(EachCollider.make(name, _land));
                    queries.terrain = terrain;
                    queries.update(new <Agent>[agent]);
                    queries.moveUntilTouch(agent, 0, 0, -4);
                    for (var k:int = 0; k < steps; k++)
                    {
                        var before:Number = agent.x;
                        queries.slide(agent, 0.4, 0.01, -0.05);
                        assertTrue(name + " " + i + ", step " + k + ": " + (agent.x - before), agent.x - before > 0.38);
                    }
                }
            }
        }

        // An edge of an agent that lies along an edge of two cells or triangles meets their common plane. Their edge is no edge of the ground.
        [Test]
        public function edgesAlongSeamsMeetThePlaneOfTheGround():void
        {
            var land:GreatLand = new GreatLand();
            land.loadHulls = true;
            land.addModel(BuiltInModel.cube());
            land.addModel(SolidModels.keel());
            for each (var slope:Number in [0, 0.25, -0.5])
            {
                var terrain:Terrain = new Terrain(9, 9, 1, -4, -4);
                fillHeights(terrain, function(column:int, row:int):Number
                    {
                        return slope * (row - 4);
                    });
                for each (var name:String in EachCollider.NAMES)
                {
                    for (var i:int = 0; i < 24; i++)
                    {
                        var agent:Agent = agentAt(i % 2 == 0 ? "cube" : "keel", i % 3 == 0 ? 0.5 : 0, i % 3 == 1 ? 0.5 : 0, 4);
                        agent.roll = i % 2 == 0 ? 45 : 0;
                        agent.heading = 30 * Math.floor(i / 6);
                        agent.heading = agent.heading == 60 ? 45 : agent.heading;
                        agent.collideAs = i % 2 == 0 ? "box" : "hull";
                        checkSeam(EachCollider.make(name, land), terrain, agent, slope, name + ", " + agent + ", slope " + slope + ", case " + i);
                    }
                }
            }
        }

        private static function checkSeam(collider:Collider, terrain:Terrain, agent:Agent, slope:Number, what:String):void
        {
            var queries:AgentQueries = new AgentQueries(collider);
            queries.terrain = terrain;
            queries.update(new <Agent>[agent]);
            var normal:Vector3D = queries.castAgent(agent, 0, 0, -8).normal;
            assertTrue(what + ": " + normal, (normal.z - slope * normal.y) / Math.sqrt(1 + slope * slope) > 1 - 1e-9);
            var options:WalkOptions = new WalkOptions();
            options.fall = 8;
            terrain.agent.isOneWay = true;
            assertTrue(what + " stands", queries.walk(agent, 0, 0, options).stands);
            terrain.agent.isOneWay = false;
        }

        [Test]
        public function whatWalksOverAHoleFalls():void
        {
            var options:WalkOptions = new WalkOptions();
            options.fall = 2;
            for each (var name:String in EachCollider.NAMES)
            {
                for each (var isBlocky:Boolean in [false, true])
                {
                    var terrain:Terrain = new Terrain(21, 21, 1, -10, -10);
                    terrain.isBlocky = isBlocky;
                    var queries:AgentQueries = new AgentQueries(EachCollider.make(name, _land));
                    var agent:Agent = agentAt("cube", -2, 0.25, 0.25);
                    agent.size = 0.25;
                    queries.terrain = terrain;
                    queries.update(new <Agent>[agent]);
                    queries.walk(agent, 2.25, 0, options);
                    assertTrue(name + " stands: " + agent, agent.z > 0);
                    agent.moveTo(-2, 0.25, 0.25);
                    terrain.setHole(10, 10, true);
                    queries.walk(agent, 2.25, 0, options);
                    assertTrue(name + " falls: " + agent, agent.z < -1);
                    assertEquals("it is the shaft's side", "[1,0,0]", directionAt(queries, new Vector3D(agent.x, agent.y, -1), new Vector3D(-1, 0, 0)));
                    assertNull("and it has no floor", queries.cast(new Vector3D(0.45, 0.45, 5), new Vector3D(0, 0, -1)));
                }
            }
        }

        // Ground that is all holes is nowhere.
        [Test]
        public function groundOfHolesIsNowhere():void
        {
            var terrain:Terrain = new Terrain(3, 3);
            for (var i:int = 0; i < 9; i++)
            {
                terrain.setHole(i % 3, i / 3, true);
            }
            for each (var name:String in EachCollider.NAMES)
            {
                var queries:AgentQueries = new AgentQueries(EachCollider.make(name, _land));
                queries.terrain = terrain;
                queries.update(new <Agent>[]);
                assertEquals(Infinity, queries.distance(agentAt("cube", 1, 1, 0), terrain.agent));
                assertFalse(queries.touchesAny(agentAt("cube", 1, 1, 0)));
            }
        }

        private static function directionAt(queries:AgentQueries, origin:Vector3D, direction:Vector3D):String
        {
            var normal:Vector3D = queries.cast(origin, direction).normal;
            return "[" + [Math.round(normal.x), Math.round(normal.y), Math.round(normal.z)].join() + "]";
        }

        [Test]
        public function eachQuestionKnowsTheGround():void
        {
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                var terrain:Terrain = new Terrain(11, 11, 1, -5, -5);
                var collision:Collision = new Collision(EachCollider.make(name, _land));
                collision.terrain = terrain;
                var queries:AgentQueries = new AgentQueries(collision);
                var on:Agent = agentAt("cube", 0, 0, 0);
                var above:Agent = agentAt("cube", 3, 0, 1);
                queries.update(new <Agent>[on, above]);
                assertStrictlyEquals(terrain, queries.terrain);
                assertStrictlyEquals(terrain.agent, queries.touching(on)[0]);
                assertEquals(0, queries.touching(above).length);
                assertTrue(queries.touchesAny(on));
                assertStrictlyEquals(on, queries.touching(terrain.agent)[0]);
                assertEquals(1, queries.touching(terrain.agent).length);
                assertStrictlyEquals(terrain.agent, queries.overlapping(new Sphere(new Vector3D(-3, 0, -7), 0.1))[0]);
                assertEquals(0, queries.overlapping(new Sphere(new Vector3D(-3, 0, 0.2), 0.1)).length);
                assertTrue(name, Math.abs(queries.distance(above, terrain.agent) - 1) < 1e-12);
                var hit:RayHit = queries.cast(new Vector3D(-3, 0, 5), new Vector3D(0, 0, -1));
                assertStrictlyEquals(terrain.agent, hit.agent);
                assertEquals(5, hit.distance);
                assertEquals(1, hit.normal.z);
                assertEquals(-1, hit.triangle);
                assertEquals(2, queries.castAll(new Vector3D(3, 0, 5), new Vector3D(0, 0, -1)).length);
                var shapeHit:ShapeHit = queries.castShape(new Sphere(new Vector3D(-3, 0, 5), 1), 0, 0, -8);
                assertStrictlyEquals(terrain.agent, shapeHit.agent);
                assertTrue(name, Math.abs(shapeHit.time - 0.5) < 1e-9 && shapeHit.normal.z == 1 && Math.abs(shapeHit.point.z) < 1e-9);
                assertEquals(2, queries.castShapeAll(new Sphere(new Vector3D(3, 0, 5), 1), 0, 0, -8).length);
                assertTrue(name, queries.overlapsAgent(above, 3, 4, -0.1) && !queries.overlapsAgent(above, 3, 4, 0.1));
                assertTrue(queries.canSee(on, above));
                terrain.raiseMound(1.5, 0, 2, 5);
                assertFalse(queries.canSee(on, above));
                var noGround:AgentFilter = new AgentFilter();
                noGround.exceptBreeds = new <String>[Collision.TERRAIN];
                assertTrue(queries.canSee(on, above, noGround));
                assertEquals(0, queries.touching(on, noGround).length);
                noGround.exceptBreeds = null;
                noGround.except = new <Agent>[terrain.agent];
                assertNull(queries.cast(new Vector3D(-3, 0, 5), new Vector3D(0, 0, -1), Infinity, noGround));
                assertEquals(1, queries.moveUntilTouch(above, 0, 0, -3, noGround));
                above.z = 1;
                terrain.reset();
                queries.moved(above);
                var contact:Contact = new Contact();
                assertTrue(name, Math.abs(queries.moveUntilTouch(above, 0, 0, -3, null, contact) - 1 / 3) < 1e-8);
                assertEquals(1, contact.normal.z);
                queries.slide(above, 1, 0.5, -1);
                assertTrue(Math.abs(above.x - 4) < 1e-8 && Math.abs(above.y - 0.5) < 1e-8 && Math.abs(above.z) < 1e-8);
                assertEquals(0, queries.near(on, 1).length);
            }
        }

        [Test]
        public function twoThatAreNoAgentsHaveNoDistance():void
        {
            var queries:AgentQueries = new AgentQueries(new BinCollider());
            var ground:Agent = new Terrain(2, 2).agent;
            var edge:Agent = new WorldBounds(0, 0, 0, 1, 1, 1).agent;
            for each (var other:Agent in [edge, new Terrain(3, 3).agent])
            {
                assertThrows(ArgumentError, /no distance/, queries.distance, ground, other);
                assertThrows(ArgumentError, /no distance/, queries.distance, other, ground);
            }
        }

        [Test]
        public function theGroundDoesNotMove():void
        {
            var queries:AgentQueries = new AgentQueries(new BinCollider());
            queries.terrain = new Terrain(3, 3, 1, -1, -1);
            queries.update(new <Agent>[]);
            assertThrows(ArgumentError, /does not move/, queries.moveUntilTouch, queries.terrain.agent, 1, 0, 0);
            assertThrows(ArgumentError, /list/, queries.moved, queries.terrain.agent);
            assertThrows(ArgumentError, /agents\[0\]/, queries.update, new <Agent>[queries.terrain.agent]);
            var agent:Agent = agentAt("cube", 0, 0, 0);
            assertTrue(queries.touchesAny(agent));
            queries.terrain = null;
            queries.update(new <Agent>[agent]);
            assertFalse("no ground any more", queries.touchesAny(agent));
        }

        // Ten times as long as it is wide.
        private static function beam():Model
        {
            var cube:Model = BuiltInModel.cube();
            var vertices:Vector.<Number> = cube.vertices.concat();
            for (var i:int = 0; i < vertices.length; i++)
            {
                vertices[i] *= i % 3 == 0 ? 1 : 0.1;
            }
            return new Model("beam", vertices, cube.triangles);
        }

        private function makeGround(i:int):void
        {
            _kind = RandomGround.KINDS[i % RandomGround.KINDS.length];
            _terrain = RandomGround.make(_kind, _random);
            _reference = new GroundReference(_terrain);
        }

        // Returns 1 if the ray meets the ground.
        private function checkRay(queries:AgentQueries, origin:Vector3D, direction:Vector3D, what:String):int
        {
            var hit:RayHit = queries.cast(origin, direction);
            var expected:Number = _reference.rayTo(origin, direction);
            var distance:Number = hit == null ? Infinity : hit.distance;
            if (distance != expected && !(Math.abs(distance - expected) < 1e-9 * (expected + _terrain.cellWidth + Math.abs(_terrain.x) + 1000)))
            {
                // through an edge or a corner, beside which rounding decides
                var isEdge:Boolean = false;
                for (var i:int = 0; i < 4 && !isEdge; i++)
                {
                    var aside:Number = 1e-9 * (_terrain.cellWidth + Math.abs(_terrain.x));
                    var moved:Vector3D = origin.add(new Vector3D(i < 2 ? aside : -aside, i % 2 == 0 ? aside : -aside, i % 3 == 0 ? aside : -aside));
                    isEdge = Math.abs(_reference.rayTo(moved, direction) - distance) < 1e-5 || _reference.rayTo(moved, direction) == distance;
                }
                assertTrue(what + ": " + distance + " instead of " + expected + " from " + origin + " along " + direction + (_terrain.isBlocky ? " columns" : " slopes"), isEdge);
            }
            if (hit != null)
            {
                assertTrue(what + ", normal", hit.normal.dotProduct(direction) <= 1e-12 && Math.abs(hit.normal.length - 1) < 1e-12);
            }
            return hit == null ? 0 : 1;
        }

        private function placeAbout(beyond:Number):Vector3D
        {
            var width:Number = _terrain.cellWidth;
            return new Vector3D(_terrain.x + width * _random.between(-beyond, _terrain.columns - 1 + beyond),
                    _terrain.y + width * _random.between(-beyond, _terrain.rows - 1 + beyond), width * _random.between(-1, 4));
        }

        private function agentAbout():Agent
        {
            var agent:Agent = new Agent(_random.pick(["cube", "sphere", "beam"]));
            var place:Vector3D = placeAbout(2);
            agent.hierarchical = _random.chance();
            agent.size = _terrain.cellWidth * _random.logBetween(0.1, 5);
            agent.heading = _random.between(0, 360);
            agent.pitch = _random.between(-90, 90);
            agent.moveTo(place.x, place.y, place.z + agent.size);
            return agent;
        }

        private function piecesOf(name:String, agent:Agent):Array
        {
            return AgentPieces.of(name, agent, _land, _models[agent.shape]);
        }

        private function distanceOf(point:Vector3D):Number
        {
            var points:Vector.<Number> = new <Number>[point.x, point.y, point.z, point.x, point.y, point.z, point.x, point.y, point.z];
            var least:Number = Infinity;
            for (var at:int = 0; at < _reference.surface.length; at += 9)
            {
                least = Math.min(least, PlainDistance.ofTriangles(points, 0, _reference.surface, at));
            }
            return least;
        }
    }
}
