package starlogo.collision
{
    import flash.errors.IllegalOperationError;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertStrictlyEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.models.BuiltInModel;
    import starlogo.queries.AgentQueries;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.WorldBounds;
    import support.MoodyBins;
    import support.agentAt;
    import support.assertThrows;
    import support.ignore;
    import support.landOf;

    use namespace engine;

    /** Contacts are those of the frame, whatever handlers do to the ground, to the edges and to breeds before they get them. */
    public class ContactsBeforeHandlersTest
    {
        private static const NEAR:Number = 1e-6;

        private var _collision:Collision;
        private var _terrain:Terrain;
        private var _bounds:WorldBounds;
        private var _ball:Agent;
        private var _agents:Vector.<Agent>;
        private var _depths:Array;

        [Before]
        public function makeGame():void
        {
            _collision = new Collision(new BinCollider());
            _terrain = new Terrain(11, 11, 1, -5, -5);
            _bounds = new WorldBounds(-9, -9, -9, 9, 9, 9);
            _collision.terrain = _terrain;
            _collision.bounds = _bounds;
            _ball = agentAt("sphere", 0, 0, -0.1, "balls");
            _agents = new <Agent>[_ball];
            _depths = [];
        }

        [Test]
        public function afterTheFrameItIsThatOfTheGroundAsItIs():void
        {
            _collision.onCollision("balls", Collision.TERRAIN, function(ball:Agent, ground:Agent):void
                {
                    raise();
                    _depths.push(depthOf(ball, ground));
                });
            _collision.update(_agents);
            _depths.push(depthOf(_ball, _terrain.agent));
            _terrain.reset();
            _depths.push(depthOf(_ball, _terrain.agent));
            _terrain.setHeights(5, 5, 1, 1, new <Number>[0]);
            _depths.push(depthOf(_ball, _terrain.agent));
            assertDepths(0.1, 5.1, 0.1, 0.1);
        }

        [Test]
        public function anAgentThatIsNotInTheListMeetsTheGroundAndTheEdgesOfTheFrame():void
        {
            var other:Agent = agentAt("sphere", 0, 0, -0.2);
            _collision.onCollision("balls", Collision.TERRAIN, function(ball:Agent, ground:Agent):void
                {
                    raise();
                    _bounds.setTo(-9, -9, 0.9, 9, 9, 9);
                    _depths.push(depthOf(other, ground), depthOf(_bounds.agent, other));
                });
            _collision.update(_agents);
            _depths.push(depthOf(other, _terrain.agent), depthOf(other, _bounds.agent));
            assertDepths(0.2, 0, 5.2, 1.1);
        }

        // Two frames use one ground at the same time, and handlers of both change it.
        [Test]
        public function eachOfTwoFramesHasItsOwnGround():void
        {
            var inner:Collision = new Collision(new BinCollider());
            inner.terrain = _terrain;
            inner.onCollision("balls", Collision.TERRAIN, function(ball:Agent, ground:Agent):void
                {
                    _terrain.setHeight(5, 5, 3);
                    _depths.push(BinCollider(inner.collisionSystem).contactOf(ball, ground).depth);
                });
            _collision.onCollision("balls", Collision.TERRAIN, function(ball:Agent, ground:Agent):void
                {
                    raise();
                    _depths.push(depthOf(ball, ground));
                    inner.update(new <Agent>[ball]);
                    _depths.push(depthOf(ball, ground));
                    _terrain.reset();
                    _depths.push(depthOf(ball, ground));
                });
            _collision.update(_agents);
            assertDepths(0.1, 5.1, 0.1, 0.1);
        }

        [Test]
        public function whatIsNoContactOfTheFrameSeesTheGroundAsItIs():void
        {
            var other:BinCollider = new BinCollider();
            var otherCollision:Collision = new Collision(other);
            otherCollision.terrain = _terrain;
            otherCollision.bounds = _bounds;
            otherCollision.onCollision("balls", Collision.TERRAIN, ignore);
            otherCollision.onCollision("balls", Collision.EDGE, ignore);
            var queries:AgentQueries = new AgentQueries(_collision);
            var eye:Vector3D = new Vector3D(0, 0, 8);
            var down:Vector3D = new Vector3D(0, 0, -1);
            _collision.onCollision("balls", Collision.TERRAIN, function(ball:Agent, ground:Agent):void
                {
                    raise();
                    _bounds.setTo(-9, -9, 0.9, 9, 9, 9);
                    _depths.push(depthOf(ball, ground), depthOf(ball, _bounds.agent));
                    _depths.push(other.contactOf(ball, ground).depth, other.contactOf(ball, _bounds.agent).depth);
                    _depths.push(queries.cast(eye, down).distance, queries.castAll(eye, down)[0].distance);
                    assertTrue(other.areColliding(ball, _bounds.agent) && queries.touchesEdge(ball, _bounds));
                    _terrain.isBlocky = true;
                    _terrain.reset();
                    _depths.push(depthOf(ball, ground), queries.cast(eye, down).distance);
                });
            otherCollision.update(_agents);
            queries.update(_agents);
            _collision.update(_agents);
            assertDepths(0.1, 0, 5.1, 1, 3, 3, 0.1, 7.1);
        }

        [Test]
        public function handlersThatChangeTheGroundInEveryFrameUseTwoGridsInTurns():void
        {
            var grids:Array = [];
            _terrain.setHole(9, 9, true);
            _collision.onCollision("balls", Collision.TERRAIN, function(ball:Agent, ground:Agent):void
                {
                    for (var i:int = 0; i < 2; i++)
                    {
                        _terrain.setHeight(5, 5, _terrain.getHeight(5, 5) + 1);
                    }
                    _depths.push(depthOf(ball, ground));
                    grids.push(_terrain.grid);
                });
            for (var frame:int = 0; frame < 4; frame++)
            {
                _collision.update(_agents);
                assertEquals(2 * frame + 2, _terrain.heightAt(0, 0));
                assertTrue(_terrain.isHole(9, 9));
                _terrain.setHeight(0, 0, frame);
                assertStrictlyEquals("a change between frames copies nothing", grids[frame], _terrain.grid);
                assertStrictlyEquals(grids[frame % 2], grids[frame]);
            }
            assertTrue(_depths.join(), _depths[0] < _depths[1] && _depths[1] < _depths[2] && _depths[2] < _depths[3]);
        }

        // The place of the ground counts for the rounding of contacts. It was that of some frame before.
        [Test]
        public function contactsWithTheGroundAreTheSameInEveryFrame():void
        {
            var depths:Array = [];
            for each (var x:Number in [-5, -5e8])
            {
                begin(x);
                for (var frame:int = 0; frame < 5; frame++)
                {
                    _collision.update(_agents);
                    assertEquals(x + ", frame " + frame, _depths[0], _depths[frame]);
                }
                depths.push(_depths[0]);
            }
            assertTrue("as far as places are rounded there: " + depths, Math.abs(depths[1] - depths[0]) < 1e-6 && depths[0] > 0.01);
        }

        private function begin(x:Number):void
        {
            makeGame();
            _collision.terrain = _terrain = new Terrain(11, 11, 1, x, -5);
            _terrain.setHeight(6, 5, 0.3);
            _ball.moveTo(x + 5.25, 0.125, -0.1);
            _collision.onCollision("balls", Collision.TERRAIN, note);
        }

        [Test]
        public function aGroundThatIsNoLongerThereHasNoHandlersOfAnyBreed():void
        {
            _collision.onCollisionStart("balls", Collision.TERRAIN, ignore);
            _collision.onCollisionEnd(Collision.ANY_BREED, Collision.ANY_BREED, function(a:Agent, b:Agent):void
                {
                    assertTrue("called with " + b, b.breed != Collision.TERRAIN && a.breed != Collision.TERRAIN);
                    _depths.push(0);
                });
            _agents.push(agentAt("sphere", 0, 0, 3), agentAt("sphere", 0, 0, 3.5));
            _collision.update(_agents);
            _collision.removeHandler("balls", Collision.TERRAIN, ignore);
            _collision.update(_agents);
            assertEquals(0, _depths.length);
            _agents.pop();
            _collision.update(_agents);
            assertEquals("once for each of the two", 2, _depths.length);
        }

        [Test]
        public function aPairOfTheGroundAndTheEdgesHasNoContact():void
        {
            for each (var pair:Array in [[_terrain.agent, _bounds.agent], [_bounds.agent, _terrain.agent]])
            {
                var text:String = "";
                try
                {
                    new BinCollider().contactOf(pair[0], pair[1]);
                }
                catch (error:ArgumentError)
                {
                    text = error.message;
                }
                assertTrue(text, text.indexOf("the ground and the edges of the world have no contact") >= 0);
            }
        }

        [Test]
        public function aHandlerForStartsComputesTheContactsOfTouchesThatBegin():void
        {
            var system:MoodyBins = new MoodyBins(null);
            var collision:Collision = new Collision(system);
            var agents:Vector.<Agent> = new <Agent>[];
            for (var i:int = 0; i < 20; i++)
            {
                agents.push(agentAt("sphere", 0.8 * i, 0, 0, "balls"));
            }
            collision.onCollisionStart("balls", "balls", note);
            assertContacts("all begin", 19);
            assertContacts("nothing has moved", 0);
            for each (var agent:Agent in agents)
            {
                agent.moveTo(agent.x, agent.y + 0.1, agent.z);
            }
            assertContacts("all have moved together", 0);
            for (i = 0; i < 20; i++)
            {
                agents[i].moveTo(agents[i].x, i == 7 ? 5 : 0, 0);
            }
            assertContacts("one has left", 0);
            for (i = 0; i < 20; i++)
            {
                agents[i].moveTo(agents[i].x, 0.1, 0);
            }
            assertContacts("it is back", 2);
            agents[3].breed = "walls";
            collision.onCollisionStart("balls", "walls", note);
            assertContacts("another breed", 2);
            collision.onCollision("balls", "walls", note);
            assertContacts("its contacts are needed in every frame", 2);
            assertContacts("now too", 2);

            function assertContacts(message:String, count:int):void
            {
                system.contactCount = 0;
                collision.update(agents);
                assertEquals(message, count, system.contactCount);
            }
        }

        // A handler has changed a breed, so the contact was not computed before the handlers.
        [Test]
        public function aLateContactThatFailsEndsTheFrame():void
        {
            var system:MoodyBins = new MoodyBins(null);
            var collision:Collision = new Collision(system);
            var stone:Agent = agentAt("sphere", 0.2, 0, 0, "stones");
            var agents:Vector.<Agent> = new <Agent>[agentAt("sphere", 0, 0, 0, "balls"), agentAt("sphere", 0.1, 0, 0, "walls"), stone];
            var mayFail:Boolean = true;
            var later:int = 0;
            collision.onCollision("balls", "walls", function(ball:Agent, wall:Agent):void
                {
                    system.refuses = mayFail;
                    stone.breed = "gems";
                });
            collision.onCollision("balls", "stones", function(ball:Agent, other:Agent):void
                {
                });
            collision.onCollision("balls", "gems", note);
            collision.onCollision("walls", "stones", function(wall:Agent, other:Agent):void
                {
                });
            collision.onCollision("walls", "gems", function(wall:Agent, gem:Agent):void
                {
                    later++;
                });
            assertThrows(Error, /no contact/, collision.update, agents);
            assertEquals("no handler has thrown it", 0, collision.handlerErrors.length);
            assertEquals("handlers after it", 0, _depths.length + later);
            assertThrows(IllegalOperationError, /failed/, collision.snapshot);
            system.refuses = mayFail = false;
            stone.breed = "stones";
            collision.update(agents);
            assertEquals("handlers of the next frame", 2, _depths.length + later);
        }

        [Test]
        public function whatSweepsButHasNotMovedTouchesNow():void
        {
            var land:GreatLand = landOf(BuiltInModel.cube());
            for each (var shape:String in ["sphere", "cube"])
            {
                var collision:Collision = new Collision(shape == "sphere" ? new BinCollider() : new TightestFitCollider(land));
                var times:Array = [];
                collision.onCollision("balls", "walls", function(ball:Agent, wall:Agent, contact:Contact):void
                    {
                        times.push(contact.time);
                    });
                collision.onCollision("balls", Collision.TERRAIN, function(ball:Agent, ground:Agent, contact:Contact):void
                    {
                        times.push(contact.time);
                    });
                collision.terrain = _terrain;
                var ball:Agent = agentAt(shape, 0, 0, 0, "balls");
                var wall:Agent = agentAt(shape, 0.5, 0, 0, "walls");
                ball.sweeps = true;
                var agents:Vector.<Agent> = new <Agent>[ball, wall];
                collision.update(agents);
                collision.update(agents);
                assertEquals("1,1,1,1", times.join());
                // moved together, they touch from the beginning on
                ball.moveTo(0, 1, 0);
                wall.moveTo(0.5, 1, 0);
                collision.update(agents);
                assertEquals(0, Math.min(times[4], times[5]));
            }
        }

        [Test]
        public function theContactOfAnAgentThatIsLoadingHasTheTime():void
        {
            var land:GreatLand = new GreatLand();
            land.expect("later");
            var contact:Contact = new Contact();
            contact.time = 0.25;
            assertEquals(1, new AgentQueries(new BinCollider(land)).moveUntilTouch(new Agent("later"), 1, 0, 0, null, contact));
            assertEquals(1, contact.time);
        }

        private function depthOf(a:Agent, b:Agent):Number
        {
            return BaseCollider(_collision.collisionSystem).contactOf(a, b).depth;
        }

        private function raise():void
        {
            for (var column:int = 0; column < 11; column++)
            {
                for (var row:int = 0; row < 11; row++)
                {
                    _terrain.setHeight(column, row, 5);
                }
            }
        }

        private function note(a:Agent, b:Agent, contact:Contact):void
        {
            _depths.push(contact.depth);
        }

        private function assertDepths(...expected):void
        {
            assertEquals(expected.length, _depths.length);
            for (var i:int = 0; i < expected.length; i++)
            {
                assertTrue(_depths[i] + ", not " + expected[i], Math.abs(_depths[i] - expected[i]) < NEAR);
            }
        }
    }
}
