package starlogo.terrain
{
    import flash.errors.IllegalOperationError;
    import flash.geom.Vector3D;
    import flash.utils.ByteArray;
    import flash.utils.Endian;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertStrictlyEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.BaseCollider;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collision;
    import starlogo.collision.Contact;
    import starlogo.collision.TightestFitCollider;
    import starlogo.models.BuiltInModel;
    import starlogo.queries.AgentFilter;
    import starlogo.queries.AgentQueries;
    import support.agentAt;
    import support.assertClose;
    import support.assertThrows;
    import support.fillHeights;
    import support.landOf;

    /** Handlers for the ground: which are called, with what, in which order. */
    public class GroundHandlersTest
    {
        private var _land:GreatLand = landOf(BuiltInModel.cube());
        private var _terrain:Terrain = new Terrain(11, 11, 1, -5, -5);
        private var _collision:Collision = new Collision(new TightestFitCollider(_land));
        private var _calls:Array = [];

        [Before]
        public function makeGame():void
        {
            _collision.terrain = _terrain;
        }

        [Test]
        public function theGroundIsTheColliderOfItsOwnHandlers():void
        {
            var cube:Agent = agentAt("cube", 0, 0, 0);
            _collision.onCollision(Collision.TERRAIN, "turtles", function(collider:Agent, collidee:Agent, contact:Contact):void
                {
                    assertStrictlyEquals(_terrain.agent, collider);
                    assertStrictlyEquals(cube, collidee);
                    assertEquals(-1, contact.normal.z);
                    note(collidee, collider);
                });
            _collision.update(new <Agent>[cube]);
            assertEquals(1, _calls.length);
        }

        // Questions see the ground as it is, also while the frame keeps the ground that it has found.
        [Test]
        public function aHandlerThatRaisesTheGroundIsNearerToIt():void
        {
            var cube:Agent = agentAt("cube", 0, 0, 5);
            var other:Agent = agentAt("cube", 0, 0, 5);
            var queries:AgentQueries = new AgentQueries(_collision);
            var agents:Vector.<Agent> = new <Agent>[cube, other];
            queries.update(agents);
            _collision.onCollision("turtles", "turtles", function(collider:Agent, collidee:Agent, contact:Contact):void
                {
                    note(collider, collidee);
                    fillHeights(_terrain, function(column:int, row:int):Number
                        {
                            return 3 + _calls.length;
                        });
                    assertClose(2 - _calls.length, queries.distance(collider, _terrain.agent), 1e-9);
                    assertClose(2 - _calls.length, queries.distance(_terrain.agent, collider), 1e-9);
                });
            _collision.update(agents);
            assertEquals(2, _calls.length);
        }

        [Test]
        public function agentsInAHoleTouchNothing():void
        {
            _terrain.setHole(5, 5, true);
            var inside:Agent = agentAt("cube", 0.5, 0.5, -3);
            var beside:Agent = agentAt("cube", 0.9, 0.5, -3);
            inside.size = beside.size = 0.5;
            _collision.onCollision("turtles", Collision.TERRAIN, note);
            _collision.update(new <Agent>[inside, beside]);
            assertEquals(String(beside.id), _calls.join());
            _terrain.setHole(5, 5, false);
            _collision.update(new <Agent>[inside, beside]);
            assertEquals("all that are under the ground", 3, _calls.length);
        }

        [Test]
        public function aHoleThatAHandlerDigsIsThereInTheNextFrame():void
        {
            var agents:Vector.<Agent> = new <Agent>[agentAt("cube", 0.5, 0.5, -0.2), agentAt("cube", 0.5, 0.5, -0.2)];
            agents[0].size = agents[1].size = 0.5;
            _collision.onCollision("turtles", Collision.TERRAIN, function(collider:Agent, collidee:Agent, contact:Contact):void
                {
                    _terrain.setHole(5, 5, true);
                    note(collider, collidee);
                    assertTrue("depth: " + contact.depth + " along " + contact.normal, contact.depth > 0.1);
                });
            _collision.update(agents);
            assertEquals("both have met the ground of the frame", 2, _calls.length);
            _collision.update(agents);
            assertEquals(2, _calls.length);
        }

        // The ground that a frame keeps has holes of its own, even if the terrain had some before.
        [Test]
        public function contactsOfAFrameAreThoseBeforeAHandlerDigs():void
        {
            var agents:Vector.<Agent> = new <Agent>[agentAt("cube", 0.5, 0.5, -0.2)];
            agents[0].size = 0.5;
            _terrain.setHole(10, 10, true);
            _collision.onCollision("turtles", Collision.TERRAIN, function(collider:Agent, collidee:Agent):void
                {
                    _terrain.setHole(5, 5, true);
                    note(collider, collidee);
                    var contact:Contact = TightestFitCollider(_collision.collisionSystem).contactOf(collider, collidee);
                    assertTrue("depth: " + contact.depth, contact.depth > 0.1);
                });
            _collision.update(agents);
            assertEquals(1, _calls.length);
        }

        [Test]
        public function aSnapshotHasTheHoles():void
        {
            var agents:Vector.<Agent> = new <Agent>[agentAt("cube", 0.5, 0.5, 0)];
            _collision.update(agents);
            var before:ByteArray = _collision.snapshot();
            _terrain.setHole(5, 5, true);
            _terrain.setHole(10, 10, true);
            var bytes:ByteArray = _collision.snapshot();
            _terrain.reset();
            _terrain.setHole(3, 3, true);
            _collision.restore(bytes, agents);
            assertTrue(_terrain.isHole(5, 5) && _terrain.isHole(10, 10));
            assertFalse(_terrain.isHole(3, 3));
            assertTrue(isNaN(_terrain.heightAt(0.5, 0.5)));
            // of four numbers the second and the last are not 0; after the third comes its count
            bytes.endian = Endian.LITTLE_ENDIAN;
            for each (var count:int in [0, 2, 3, -1])
            {
                var broken:ByteArray = new ByteArray();
                broken.endian = Endian.LITTLE_ENDIAN;
                broken.writeBytes(bytes);
                broken.position = broken.length - 8;
                assertEquals(1, broken.readInt());
                broken.position -= 4;
                broken.writeInt(count);
                assertThrows(ArgumentError, /no snapshot/, _collision.restore, broken, agents);
            }
            _collision.restore(before, agents);
            assertFalse(_terrain.isHole(5, 5) || _terrain.isHole(10, 10));
        }

        [Test]
        public function whatAFilterLeavesOutMeetsNoGround():void
        {
            var filter:AgentFilter = new AgentFilter();
            var out:Agent = agentAt("cube", 0, 0, 0);
            filter.except = new <Agent>[out];
            _collision.filter = filter;
            _collision.onCollision("turtles", Collision.TERRAIN, note);
            var cube:Agent = agentAt("cube", 2, 0, 0);
            _collision.update(new <Agent>[out, cube]);
            assertEquals(cube.id, _calls.join());
        }

        [Test]
        public function aSphereThatMeetsASharpEdgeHasTheNormalOfTheEdge():void
        {
            for each (var far:Number in [0, 1e5, -1e6, 1e7])
            {
                checkSharpEdges(far);
            }
        }

        private function checkSharpEdges(far:Number):void
        {
            // the border's wall is behind the edge, as seen from the sphere
            _terrain = new Terrain(2, 2, 1, far, -far);
            _collision = new Collision(new BinCollider());
            _collision.terrain = _terrain;
            var normal:Vector3D;
            _collision.onCollision("turtles", Collision.TERRAIN, function(collider:Agent, collidee:Agent, contact:Contact):void
                {
                    normal = contact.normal.clone();
                });
            var sphere:Agent = agentAt("cube", 0, 0, 0);
            sphere.sweeps = true;
            var agents:Vector.<Agent> = new <Agent>[sphere];
            for (var i:int = 0; i < 80; i++)
            {
                var isAlongX:Boolean = i % 4 < 2;
                var isFirst:Boolean = i % 2 == 0;
                var at:Number = 0.1 + i / 100;
                var from:Number = isFirst ? 0.3 : 0.7;
                var low:Number = -2 - i / 40;
                _terrain.setHeights(0, 0, 2, 2, isFirst ? new <Number>[1, isAlongX ? low : 1, isAlongX ? 1 : low, low]
                        : new <Number>[low, isAlongX ? 1 : low, isAlongX ? low : 1, 1]);
                sphere.jumpTo(far + (isAlongX ? from : at), -far + (isAlongX ? at : from), 3);
                _collision.update(agents);
                sphere.z = -1;
                _collision.update(agents);
                var across:Number = isFirst ? 0.6 : -0.6;
                var expected:Vector3D = new Vector3D(isAlongX ? across : 0, isAlongX ? 0 : across, 0.8);
                assertTrue(far + ", " + i + ": " + normal, Vector3D.distance(expected, normal) < 1e-9 + 1e-14 * Math.abs(far));
            }
        }

        [Test]
        public function pairsOfAFrameThatSweepsAreInTheOrderOfTheirTimes():void
        {
            var late:Agent = agentAt("cube", -2, 0, 4);
            var early:Agent = agentAt("cube", 2, 0, 2);
            late.sweeps = early.sweeps = true;
            _collision.onCollision("turtles", Collision.TERRAIN, note);
            var agents:Vector.<Agent> = new <Agent>[late, early];
            _collision.update(agents);
            late.z = early.z = -1;
            _collision.update(agents);
            assertEquals([early.id, late.id].join(), _calls.join());
        }

        [Test]
        public function aSnapshotHasTheHeightsAndTheTouches():void
        {
            var cube:Agent = agentAt("cube", 0, 0, 0.5);
            var agents:Vector.<Agent> = new <Agent>[cube];
            _collision.onCollisionStart("turtles", Collision.TERRAIN, noteAs("start"));
            _collision.onCollisionEnd("turtles", Collision.TERRAIN, noteAs("end"));
            _terrain.raiseMound(0, 0, 5, 1);
            _terrain.setHeight(10, 10, -3);
            _collision.update(agents);
            var bytes:ByteArray = _collision.snapshot();
            var listed:Vector.<Agent> = _collision.lastAgents.concat();
            _terrain.reset();
            _terrain.isBlocky = true;
            _collision.update(agents);
            assertEquals("start,end", _calls.join());
            _collision.restore(bytes, listed);
            assertFalse(_terrain.isBlocky);
            assertEquals(1, _terrain.heightAt(0, 0));
            assertEquals(-3, _terrain.getHeight(10, 10));
            assertEquals(0, _terrain.getHeight(0, 10));
            _collision.update(agents);
            assertEquals("it goes on touching", "start,end", _calls.join());
            _terrain.reset();
            _collision.update(agents);
            assertEquals("start,end,end", _calls.join());

            _terrain.setHeight(3, 3, 9);
            _collision.terrain = null;
            assertThrows(ArgumentError, /without ground/, _collision.restore, bytes, listed);
            _collision.terrain = new Terrain(5, 5);
            assertThrows(ArgumentError, /11 by 11/, _collision.restore, bytes, listed);
            _collision.terrain = _terrain;
            while (bytes.length > 0)
            {
                bytes.length -= 1;
                assertThrows(ArgumentError, /no snapshot/, _collision.restore, bytes, listed);
            }
            assertEquals("nothing has changed", 9, _terrain.getHeight(3, 3));
        }

        [Test]
        public function aSnapshotAfterAnExchangeGoesOnTheSame():void
        {
            var grounds:Array = [null, new Terrain(11, 11, 1, -5, -5), new Terrain(3, 3, 4, -4, -4)];
            for each (var ground:Terrain in grounds)
            {
                for each (var bounds:WorldBounds in [null, new WorldBounds(-5, -5, 0.25, 5, 5, 9)])
                {
                    prepareExchange();
                    _collision.terrain = ground;
                    _collision.bounds = bounds;
                    var bytes:ByteArray = _collision.snapshot();
                    var listed:Vector.<Agent> = _collision.lastAgents.concat();
                    _calls.length = 0;
                    _collision.update(listed);
                    var expected:String = _calls.join();
                    assertTrue(expected, expected.indexOf("end") >= 0);
                    _calls.length = 0;
                    _collision.restore(bytes, listed);
                    _collision.update(listed);
                    assertEquals("again", expected, _calls.join());
                    var first:Collision = _collision;
                    prepareExchange();
                    _collision.terrain = ground;
                    _collision.bounds = bounds;
                    _calls.length = 0;
                    _collision.restore(bytes, listed);
                    _collision.update(listed);
                    assertEquals("elsewhere", expected, _calls.join());
                    assertTrue(first !== _collision);
                }
            }
        }

        // Of a frame in which an agent touches the ground and an edge.
        private function prepareExchange():void
        {
            _collision = new Collision(new BinCollider());
            _collision.terrain = new Terrain(11, 11, 1, -5, -5);
            _collision.bounds = new WorldBounds(-5, -5, 0.25, 5, 5, 9);
            for each (var other:String in [Collision.TERRAIN, Collision.EDGE])
            {
                _collision.onCollisionStart("turtles", other, function(a:Agent, b:Agent):void
                    {
                        _calls.push("start" + b.breed);
                    });
                _collision.onCollisionEnd("turtles", other, function(a:Agent, b:Agent):void
                    {
                        _calls.push("end" + b.breed);
                    });
            }
            _collision.update(new <Agent>[agentAt("sphere", 0, 0, 0)]);
        }

        [Test]
        public function aSnapshotGoesIntoTheSameGroundAlone():void
        {
            var agents:Vector.<Agent> = new <Agent>[];
            _collision.update(agents);
            var bytes:ByteArray = _collision.snapshot();
            for each (var other:Terrain in [new Terrain(11, 11, 2, -5, -5), new Terrain(11, 11, 1, -5, 0), new Terrain(11, 12, 1, -5, -5)])
            {
                _collision.terrain = other;
                assertThrows(ArgumentError, /no snapshot with this ground, but with 11 by 11 heights from \(-5, -5\) on, in cells 1 wide/, _collision.restore,
                        bytes, agents);
            }
        }

        [Test]
        public function damagedHeightsAreRefused():void
        {
            var agents:Vector.<Agent> = new <Agent>[];
            _collision.update(agents);
            _terrain.setHeight(2, 0, 5);
            var bytes:ByteArray = _collision.snapshot();
            bytes.endian = Endian.LITTLE_ENDIAN;
            // the heights begin after the mark, what is in it, four counts, columns, rows, width, place and a flag: two of 0, a 5, and 118 of 0
            var firstAt:int = 54;
            for each (var wrong:Number in [NaN, Infinity, 2e9, 0])
            {
                var broken:ByteArray = new ByteArray();
                broken.endian = Endian.LITTLE_ENDIAN;
                broken.writeBytes(bytes);
                broken.position = firstAt + 12;
                assertEquals(5, broken.readDouble());
                broken.position -= 8;
                broken.writeDouble(wrong);
                assertThrows(ArgumentError, /no snapshot/, _collision.restore, broken, agents);
            }
            for each (var count:int in [0, 1, 3, 118, 119, 121, int.MAX_VALUE, -1])
            {
                broken = new ByteArray();
                broken.endian = Endian.LITTLE_ENDIAN;
                broken.writeBytes(bytes);
                broken.position = firstAt + 8;
                assertEquals(2, broken.readInt());
                broken.position -= 4;
                broken.writeInt(count);
                assertThrows(ArgumentError, /no snapshot/, _collision.restore, broken, agents);
            }
            _terrain.reset();
            _collision.restore(bytes, agents);
            assertEquals(5, _terrain.getHeight(2, 0));
        }

        [Test]
        public function noListMayHoldItAndNoSystemOfAGamesOwnHasOne():void
        {
            var own:Collision = new Collision(new BaseCollider(new BinCollider()));
            own.update(new <Agent>[]);
            own.terrain = _terrain;
            assertThrows(IllegalOperationError, /./, own.update, new <Agent>[]);
            var agents:Vector.<Agent> = new <Agent>[agentAt("cube", 0, 0, 0), _terrain.agent];
            assertThrows(ArgumentError, /agents\[1\]/, _collision.update, agents);
            assertThrows(ArgumentError, /agents\[1\]/, new BinCollider().findCollisions, agents);
        }

        private function note(collider:Agent, collidee:Agent):void
        {
            _calls.push(collider.id);
        }

        private function noteAs(what:String):Function
        {
            return function(collider:Agent, collidee:Agent):void
            {
                assertStrictlyEquals(_terrain.agent, collidee);
                _calls.push(what);
            };
        }
    }
}
