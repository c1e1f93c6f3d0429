package starlogo.queries
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.Collision;
    import starlogo.models.BuiltInModel;
    import starlogo.terrain.Terrain;
    import support.Complaints;
    import support.EachCollider;
    import support.Effort;
    import support.agentAt;
    import support.assertClose;
    import support.landOf;

    /** Platforms that stop only what comes from above. The hero is a cube of edge 1, a plank is 4 by 4 by 0.5; both have their places below. */
    public class OneWayTest
    {
        private static const SYSTEMS:Array = ["tightest fits", "hierarchies", "triangles"];
        private static const NEAR:Number = 1e-6;
        private static const TOP:Number = 2.5;

        private var _greatLand:GreatLand = landOf(BuiltInModel.box(1, 1, 1, "hero"), BuiltInModel.box(4, 4, 0.5, "plank"));
        private var _options:WalkOptions = new WalkOptions();
        private var _hero:Agent;
        private var _plank:Agent;
        private var _queries:AgentQueries;

        [Test]
        public function jumpsUpThroughItAndLands():void
        {
            for each (var name:String in SYSTEMS)
            {
                begin(name, 0, 0, 0);
                assertEquals(name + ": up", 1, _queries.slide(_hero, 0, 0, 4));
                assertClose(4, _hero.z, NEAR, name);
                assertClose(1.5 / 4, _queries.slide(_hero, 0, 0, -4), NEAR, name + ": down");
                assertClose(TOP, _hero.z, NEAR, name);
                // from halfway, where the jump of the game ends, it falls back
                _hero.moveTo(0, 0, 2.2);
                _queries.moved(_hero);
                assertEquals(name + ": within", 1, _queries.slide(_hero, 0, 0, -2));
                _plank.isOneWay = false;
                assertClose(0.8 / 4, _queries.slide(_hero, 0, 0, 4), NEAR, name + ": a ceiling");
            }
        }

        [Test]
        public function movesUntilItTouchesFromAbove():void
        {
            for each (var name:String in SYSTEMS)
            {
                begin(name, 0, 0, 0);
                assertEquals(name, 1, _queries.moveUntilTouch(_hero, 0, 0, 4));
                assertClose(1.5 / 4, _queries.moveUntilTouch(_hero, 0, 0, -4), NEAR, name);
                assertTrue(name, _queries.touchesAny(_hero));
                assertEquals(name + ": again", 0, _queries.moveUntilTouch(_hero, 0, 0, -4));
                assertEquals(name + ": beside", 1, _queries.moveUntilTouch(_hero, -6, 0, 0));
                _hero.moveTo(-6, 0, 2);
                _queries.moved(_hero);
                assertTrue(name + ": from the side", _queries.castAgent(_hero, 12, 0, 0) == null);
                _hero.moveTo(0, 0, 6);
                _queries.moved(_hero);
                assertEquals(name + ": cast", _plank, _queries.castAgent(_hero, 0, 0, -12).agent);
            }
        }

        [Test]
        public function walksThroughItsSideAndOverItsTop():void
        {
            for each (var name:String in SYSTEMS)
            {
                begin(name, -3, 0, 2);
                _options.fall = 0;
                for (var i:int = 0; i < 30; i++)
                {
                    var footing:Footing = _queries.walk(_hero, 0.2, 0, _options);
                    assertClose(1, footing.part, NEAR, name + ": passes");
                    assertEquals(name + ": is not pushed", 0, footing.pushed);
                }
                assertClose(3, _hero.x, NEAR, name);
                _hero.moveTo(0, 0, TOP);
                _queries.moved(_hero);
                footing = _queries.walk(_hero, 0.2, 0, _options);
                assertTrue(name, footing.stands);
                assertEquals(name, _plank, footing.on);
                assertClose(TOP, _hero.z, NEAR, name);
            }
        }

        [Test]
        public function aPushOutOfSomethingElseLeavesItWithinThePlatform():void
        {
            for each (var name:String in SYSTEMS)
            {
                begin(name, 0, 0, 2);
                _queries.update(new <Agent>[_hero, _plank, agentAt("hero", 0.9, 0, 2)]);
                _options.fall = 0;
                assertClose(0.1, _queries.walk(_hero, 0, 0, _options).pushed, NEAR, name);
                assertClose(-0.1, _hero.x, NEAR, name);
                assertClose(2, _hero.z, NEAR, name);
            }
        }

        // Blocks stand on a floor of tiles. The side of a block and a needless plane at the edge of a tile are met in the same corner.
        [Test]
        public function slidesOverTilesAsIfItWereNotThere():void
        {
            var ways:Array = [[0.3, 0.05, -0.3, 0, 0], [0.3, 0.5, -0.3, 30, -1e-8], [0.5, 0.05, -1, 30, -1e-8], [0.3, 1, -0.3, 30, -1e-8]];
            for each (var way:Array in ways)
            {
                _hero = agentAt("hero", 0, 0, way[4]);
                _hero.heading = way[3];
                var agents:Vector.<Agent> = new <Agent>[_hero];
                for (var x:int = -2; x < 6; x++)
                {
                    for (var y:int = -2; y < 4; y++)
                    {
                        agents.push(agentAt("hero", x, y, -1));
                        if (x > 0 && y > -2)
                        {
                            var block:Agent = agentAt("hero", x, y, 0);
                            block.isOneWay = true;
                            agents.push(block);
                        }
                    }
                }
                _queries = new AgentQueries(EachCollider.make("triangles", _greatLand));
                _queries.update(agents);
                for (var i:int = 0; i < 4; i++)
                {
                    _queries.slide(_hero, way[0], way[1], way[2]);
                }
                assertClose(4 * way[0], _hero.x, NEAR, way + ": x");
                assertClose(4 * way[1], _hero.y, NEAR, way + ": y");
            }
        }

        [Test]
        public function carriesItsWalker():void
        {
            for each (var name:String in SYSTEMS)
            {
                begin(name, 0, 0, TOP);
                _queries.walk(_hero, 0, 0, _options);
                for each (var rise:Number in [0.3, -0.3, 0])
                {
                    var z:Number = _hero.z;
                    _plank.moveTo(_plank.x + 0.2, 0, _plank.z + rise);
                    _queries.moved(_plank);
                    assertEquals(name, _plank, _queries.walk(_hero, 0, 0, _options).on);
                    assertClose(z + rise, _hero.z, NEAR, name);
                    assertClose(_plank.x, _hero.x, NEAR, name);
                }
            }
        }

        [Test]
        public function whatRisesIntoItsWalkerTakesItAlong():void
        {
            for each (var name:String in SYSTEMS)
            {
                for each (var speed:Number in [0.01, 0.03, 0.1, 0.6])
                {
                    for (var from:Number = 4; from < 4.2; from += 0.02)
                    {
                        var text:String = name + ", from " + from + " at " + speed;
                        begin(name, 0.3, 0, from);
                        assertTrue(text, fallOntoLift(speed));
                        assertClose(_plank.z + 0.5, _hero.z, NEAR, text);
                    }
                }
            }
        }

        // Falls faster and faster towards the plank, which rises. Returns whether the hero stands on it in the end.
        private function fallOntoLift(speed:Number):Boolean
        {
            var footing:Footing = new Footing();
            _options.fall = 0;
            for (var i:int = 0; i < 40; i++)
            {
                _plank.z += speed;
                _queries.update(new <Agent>[_hero, _plank]);
                _options.fall = footing.stands ? 0 : _options.fall + 0.008;
                _queries.walk(_hero, 0, 0, _options, footing);
            }
            return footing.on == _plank;
        }

        [Test]
        public function whatRisesFromBelowOrComesByAJumpPasses():void
        {
            for each (var name:String in SYSTEMS)
            {
                begin(name, 0, 0, 2.2);
                _plank.z += 0.1;
                assertPasses(name + ": within it before");
                begin(name, 0, 0, 3);
                _plank.jumpTo(0, 0, 2.8);
                assertPasses(name + ": a jump");
                begin(name, 0, 0, 3);
                _plank.z += 0.8;
                _queries.update(new <Agent>[_hero, _plank]);
                _queries.update(new <Agent>[_hero, _plank]);
                assertClose(0, _queries.walk(_hero, 0, 0, _options).pushed, 0, name + ": it rose before the last update");
                begin(name, 0, 0, 3);
                _plank.z += 0.8;
                var roof:Agent = agentAt("plank", 0, 0, 4.1);
                _queries.update(new <Agent>[_hero, _plank, roof]);
                assertClose(0.1, _queries.walk(_hero, 0, 0, _options).pushed, NEAR, name + ": as far as there is room");
            }
        }

        /** A platform leads its walker up to its top, however far it has risen. */
        [Test]
        public function whoIsTakenAlongStandsOnIt():void
        {
            for each (var name:String in SYSTEMS)
            {
                for each (var gap:Number in [0.01, 0.3, 0.79])
                {
                    begin(name, 0, 0, TOP + gap);
                    _plank.z += 0.8;
                    assertIsLifted(name + ", from " + gap, 0.8 - gap);
                }
            }
        }

        /** A rise counts since the update before the last one, whatever reads the platform between the two, and whatever moves it. */
        [Test]
        public function aRiseCountsHoweverThePlatformMoves():void
        {
            for each (var name:String in SYSTEMS)
            {
                begin(name, 0, 0, 3);
                _plank.z += 0.8;
                _queries.refresh(_plank);
                assertClose(0.3, _queries.walk(_hero, 0, 0, _options).pushed, NEAR, name + ": refreshed after the update");
                begin(name, 0, 0, 3);
                _plank.z += 0.8;
                _queries.refresh(_plank);
                assertIsLifted(name + ": refreshed before the update", 0.3);
                begin(name, 0, 0, 3);
                _plank.z += 0.6;
                _queries.refresh(_plank);
                _plank.z += 0.2;
                assertIsLifted(name + ": refreshed on its way", 0.3);
                begin(name, 0, 0, 3);
                _queries.slide(_plank, 0, 0, 0.8, AgentFilter.ofBreeds("none"));
                assertIsLifted(name + ": it slid", 0.3);
                begin(name, 0, 0, 3);
                _plank.isOneWay = false;
                _plank.z += 0.8;
                _queries.update(new <Agent>[_hero, _plank]);
                _plank.isOneWay = true;
                assertClose(0.3, _queries.walk(_hero, 0, 0, _options).pushed, NEAR, name + ": one-way since");
            }
        }

        [Test]
        public function aRiseCountsInTheFrameOfAnotherCollisionSystem():void
        {
            var collision:Collision = new Collision(EachCollider.make(SYSTEMS[0], _greatLand));
            begin(SYSTEMS[0], 0, 0, 3);
            _queries = new AgentQueries(collision);
            _queries.update(new <Agent>[_plank, agentAt("hero", 9, 0, 0), _hero]);
            _plank.z += 0.8;
            collision.collisionSystem = EachCollider.make(SYSTEMS[1], _greatLand);
            assertIsLifted("exchanged", 0.3);
        }

        [Test]
        public function aJumpEndsARise():void
        {
            for each (var name:String in SYSTEMS)
            {
                begin(name, 0, 0, 3);
                _plank.moveTo(9, 0, 2.8);
                _queries.update(new <Agent>[_hero, _plank]);
                _plank.jumpTo(0, 0, 2.8);
                _queries.refresh(_plank);
                assertClose(0, _queries.walk(_hero, 0, 0, _options).pushed, 0, name + ": refreshed after the jump");
                begin(name, 0, 0, 3.1);
                _plank.jumpTo(0, 0, 2.3);
                _queries.refresh(_plank);
                _queries.update(new <Agent>[_hero, _plank]);
                _plank.z += 0.5;
                assertIsLifted(name + ": it rose after the jump", 0.2);
            }
        }

        /** A row of the table that is free again belongs to another platform. */
        [Test]
        public function aPlatformThatIsNewHasNotRisen():void
        {
            begin(SYSTEMS[0], 0, 0, 3);
            _queries.update(new <Agent>[_hero]);
            _queries.update(new <Agent>[_hero]);
            _plank = agentAt("plank", 0, 0, 2.8);
            _plank.isOneWay = true;
            assertPasses("new");
        }

        private function assertIsLifted(text:String, height:Number):void
        {
            _options.fall = 0;
            _queries.update(new <Agent>[_hero, _plank]);
            var footing:Footing = _queries.walk(_hero, 0, 0, _options);
            assertEquals(text, _plank, footing.on);
            assertClose(height, footing.pushed, NEAR, text);
            assertClose(_plank.z + 0.5, _hero.z, NEAR, text);
        }

        private function assertPasses(text:String):void
        {
            _options.fall = 0.01;
            _queries.update(new <Agent>[_hero, _plank]);
            var z:Number = _hero.z;
            var footing:Footing = _queries.walk(_hero, 0, 0, _options);
            assertEquals(text, null, footing.on);
            assertClose(z - 0.01, _hero.z, NEAR, text);
        }

        [Test]
        public function itsSlopesStopUpTo45Degrees():void
        {
            for each (var name:String in SYSTEMS)
            {
                for each (var pitch:Number in [30, 44, 46, 60])
                {
                    begin(name, 0, 0, 6);
                    _plank.pitch = pitch;
                    _queries.moved(_plank);
                    assertEquals(name + ", " + pitch, pitch > 45, _queries.moveUntilTouch(_hero, 0, 0, -12) == 1);
                }
            }
        }

        [Test]
        public function collisionsAndRaysSeeIt():void
        {
            begin("tightest fits", 0, 0, 1.5);
            assertTrue(_queries.touchesAny(_hero));
            assertEquals(_plank, _queries.cast(new Vector3D(0, 0, -3), Vector3D.Z_AXIS, Infinity, AgentFilter.ofBreeds("planks")).agent);
            assertTrue(EachCollider.make("tightest fits", _greatLand).areColliding(_hero, _plank));
        }

        [Test]
        public function theGroundToo():void
        {
            begin("tightest fits", 0, 0, -5);
            var terrain:Terrain = new Terrain(10, 10, 1, -5, -5);
            terrain.agent.isOneWay = true;
            _plank.moveTo(0, 0, 100);
            _queries.terrain = terrain;
            _queries.update(new <Agent>[_hero, _plank]);
            assertEquals(1, _queries.slide(_hero, 0, 0, 8));
            assertClose(3 / 8, _queries.slide(_hero, 0, 0, -8), NEAR);
        }

        /** The rule for boxes: a point that moves stops where it enters the top of a box that is larger by the hero, and that it is not in. */
        [Test]
        public function motionsAreAsTheRuleForBoxesSays():void
        {
            var random:SeededRandom = new SeededRandom(7350);
            var wrong:Complaints = new Complaints();
            var stopped:int = 0;
            var passed:int = 0;
            for (var i:int = 0; i < Effort.choose(600, 20000); i++)
            {
                var agents:Vector.<Agent> = new Vector.<Agent>();
                _hero = agentAt("hero", random.between(-4, 4), random.between(-4, 4), random.between(-3, 4));
                agents.push(_hero);
                for (var k:int = 0; k < 3; k++)
                {
                    var plank:Agent = agentAt("plank", random.between(-3, 3), random.between(-3, 3), 1.5 * k - 1);
                    plank.isOneWay = true;
                    agents.push(plank);
                }
                var way:Vector3D = new Vector3D(random.between(-6, 6), random.between(-6, 6), random.between(-6, 6));
                var expected:Number = 1;
                var isClear:Boolean = true;
                for (k = 1; k < agents.length; k++)
                {
                    var part:Number = entryFromAbove(_hero, agents[k], way);
                    isClear &&= part == part;
                    expected = Math.min(expected, part);
                }
                if (!isClear)
                {
                    continue;
                }
                _queries = new AgentQueries(EachCollider.make(SYSTEMS[i % 3], _greatLand));
                _queries.update(agents);
                part = _queries.moveUntilTouch(_hero, way.x, way.y, way.z);
                wrong.addIf(Math.abs(part - expected) > NEAR, SYSTEMS[i % 3], i + ": " + part + " for " + expected);
                expected < 1 ? stopped++ : passed++;
            }
            wrong.assertNone();
            assertTrue(stopped + " stopped, " + passed + " passed", stopped > Effort.choose(50, 2000) && passed > Effort.choose(50, 2000));
        }

        // Infinity if the box stops no part of the way, NaN if rounding may decide.
        private static function entryFromAbove(hero:Agent, plank:Agent, way:Vector3D):Number
        {
            const GAP:Number = 1e-4;
            var enters:Number = -Infinity;
            var leaves:Number = Infinity;
            var isTop:Boolean = false;
            var second:Number = -Infinity;
            for each (var axis:String in ["x", "y", "z"])
            {
                var middle:Number = plank[axis] - hero[axis] + (axis == "z" ? (0.5 - 1) / 2 : 0);
                var half:Number = axis == "z" ? 0.75 : 2.5;
                var near:Number = Math.min((middle - half) / way[axis], (middle + half) / way[axis]);
                var far:Number = Math.max((middle - half) / way[axis], (middle + half) / way[axis]);
                leaves = Math.min(leaves, far);
                if (near > enters)
                {
                    second = enters;
                    enters = near;
                    isTop = axis == "z" && way.z < 0;
                }
                else
                {
                    second = Math.max(second, near);
                }
            }
            if (Math.abs(enters - leaves) < GAP || Math.abs(enters) < GAP || enters - second < GAP || Math.abs(enters - 1) < GAP)
            {
                return NaN;
            }
            return isTop && enters > 0 && enters < Math.min(leaves, 1) ? enters : Infinity;
        }

        private function begin(system:String, x:Number, y:Number, z:Number):void
        {
            _hero = agentAt("hero", x, y, z);
            _plank = agentAt("plank", 0, 0, 2);
            _plank.breed = "planks";
            _plank.isOneWay = true;
            _queries = new AgentQueries(EachCollider.make(system, _greatLand));
            _queries.update(new <Agent>[_hero, _plank]);
        }
    }
}
