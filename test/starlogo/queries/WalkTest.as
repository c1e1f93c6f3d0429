package starlogo.queries
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertStrictlyEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.TightestFitCollider;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ModelLoader;
    import starlogo.terrain.Terrain;
    import support.Complaints;
    import support.EachCollider;
    import support.Effort;
    import support.agentAt;
    import support.assertThrows;
    import support.assign;
    import support.fillHeights;
    import support.landOf;

    /** Agents that walk: over tiles and hills, along walls, off cliffs. WalkWorldsTest has ramps and stairs. */
    public class WalkTest
    {
        // A BinCollider has no flat floors.
        private static const NAMES:Array = ["tightest fits", "hierarchies", "triangles", "combinations", "combinations, exact"];
        private static const WALKERS:Array = ["sphere", "cube", "cylinder"];
        private static const NEAR:Number = 1e-6;

        private var _greatLand:GreatLand = landOf(BuiltInModel.sphere(), BuiltInModel.cube(), BuiltInModel.cylinder());

        private var _random:SeededRandom = new SeededRandom(3809);
        private var _wrong:Complaints = new Complaints();
        private var _options:WalkOptions = new WalkOptions();
        private var _footing:Footing = new Footing();

        [Test]
        public function slopesAndStepsAtTheLimitsAreWalked():void
        {
            _options.fall = 0;
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                for each (var shape:String in WALKERS)
                {
                    for each (var isBlocky:Boolean in [false, true])
                    {
                        var terrain:Terrain = new Terrain(12, 5, 1, -2, -2);
                        terrain.isBlocky = isBlocky;
                        // slopes of 45 degrees, or steps as high as stepHeight and snap
                        fillHeights(terrain, function(column:int, row:int):Number
                            {
                                return (isBlocky ? 0.25 : 1) * column;
                            });
                        var walker:Agent = walkerAt(shape, 0, 0.1, 3);
                        var queries:AgentQueries = queriesOf(name, new <Agent>[walker]);
                        queries.terrain = terrain;
                        queries.update(new <Agent>[walker]);
                        queries.moveUntilTouch(walker, 0, 0, -9);
                        for each (var step:Number in [0.05, -0.05])
                        {
                            for (var i:int = 1; i <= 40; i++)
                            {
                                queries.walk(walker, step, 0, _options, _footing);
                                var x:Number = step > 0 ? 0.05 * i : 2 - 0.05 * i;
                                assertTrue([name, shape, isBlocky, step, i, walker.x, _footing.stands].join(), _footing.stands && Math.abs(walker.x - x) < NEAR);
                                assertStrictlyEquals(terrain.agent, _footing.on);
                                assertTrue("normal " + _footing.normal, isBlocky || Math.abs(_footing.normal.z - Math.SQRT1_2) < 1e-3);
                            }
                        }
                    }
                }
            }
        }

        /** A round foot slides over an edge by up to (1 - cos slopeDegrees) of its radius, as on any slope. A flat one keeps to the step. */
        [Test]
        public function roundFeetClimbHigherThanFlatOnes():void
        {
            var options:WalkOptions = new WalkOptions();
            for each (var limits:Array in [[0.2, 45, 0.3], [0, 45, 1], [0.3, 30, 0.5], [0.25, 10, 0.3], [0.5, 60, 0.4]])
            {
                options.stepHeight = limits[0];
                options.slopeDegrees = limits[1];
                var radius:Number = limits[2];
                var over:Number = (1 - Math.cos(limits[1] * Math.PI / 180)) * radius;
                var land:GreatLand = landOf(BuiltInModel.capsule(radius, 4 * radius, "round"), BuiltInModel.box(2 * radius, 2 * radius, 4 * radius, "flat"));
                for each (var isOnBlocks:Boolean in [false, true])
                {
                    // short walks may not come far enough onto the edge
                    assertTrue("round " + limits, climbs(land, options, "round", limits[0] + over - 0.005, radius, isOnBlocks));
                    assertTrue("flat " + limits, limits[0] == 0 || climbs(land, options, "flat", limits[0] - 1e-6, 0.1, isOnBlocks));
                    for each (var stride:Number in [0.02, 0.1, radius])
                    {
                        assertFalse("round " + limits, climbs(land, options, "round", limits[0] + over + 0.005, stride, isOnBlocks));
                        assertFalse("flat " + limits, climbs(land, options, "flat", limits[0] + 0.005, stride, isOnBlocks));
                    }
                }
            }
        }

        // Whether an agent that walks against a step of the ground, or of a box, comes upon it.
        private function climbs(land:GreatLand, options:WalkOptions, shape:String, height:Number, stride:Number, isOnBlocks:Boolean):Boolean
        {
            var walker:Agent = agentAt(shape, 0, 0, 0);
            var terrain:Terrain = new Terrain(12, 5, 1, -2, -2);
            var agents:Vector.<Agent> = new <Agent>[walker];
            terrain.isBlocky = true;
            if (isOnBlocks)
            {
                fillHeights(terrain, function(column:int, row:int):Number
                    {
                        return column >= 4 ? height : 0;
                    });
            }
            else
            {
                land.addModel(BuiltInModel.box(4, 4, height, "step"));
                agents.push(agentAt("step", 3.5, 0, 0));
            }
            var queries:AgentQueries = new AgentQueries(new TightestFitCollider(land));
            queries.terrain = terrain;
            queries.update(agents);
            for (var way:Number = 0; way < 4; way += stride)
            {
                queries.walk(walker, stride, 0, options, _footing);
            }
            return _footing.stands && walker.z > height - 0.001;
        }

        [Test]
        public function longStridesLeadUpStairs():void
        {
            const RISE:Number = 0.24;
            var land:GreatLand = landOf(BuiltInModel.capsule(0.3, 1.8, "hero"));
            var terrain:Terrain = new Terrain(26, 5, 0.4, -4, -0.8);
            terrain.isBlocky = true;
            fillHeights(terrain, function(column:int, row:int):Number
                {
                    return RISE * Math.max(0, Math.min(6, column - 12));
                });
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                // half a patch and more ends at the edge of the next step but one, where a round agent hangs a step higher
                for each (var stride:Number in [0.1, 0.25, 0.5, 0.8, 1, 2])
                {
                    var hero:Agent = agentAt("hero", -2, 0, 0.001);
                    var queries:AgentQueries = new AgentQueries(EachCollider.make(name, land));
                    queries.terrain = terrain;
                    queries.update(new <Agent>[hero]);
                    for (var walks:int = 0; walks < 60 && hero.z < 6 * RISE - NEAR; walks++)
                    {
                        var x:Number = hero.x;
                        queries.walk(hero, stride, 0, null, _footing);
                        assertTrue([name, stride, walks, hero.x - x].join(), _footing.stands && hero.x > x && hero.x <= x + stride + NEAR);
                    }
                    assertTrue([name, stride, hero.x, hero.z].join(), walks < 60);
                }
            }
        }

        [Test]
        public function longStridesLeadOverTheUpperEndOfARamp():void
        {
            const RISE:Number = 0.36;
            var land:GreatLand = landOf(BuiltInModel.capsule(0.3, 1.8, "hero"));
            // 42 degrees from x = 0.8 to 3.2
            var terrain:Terrain = new Terrain(26, 5, 0.4, -4, -0.8);
            fillHeights(terrain, function(column:int, row:int):Number
                {
                    return RISE * Math.max(0, Math.min(6, column - 12));
                });
            _options.fall = 0;
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                // the longest end up to 0.9 above the plateau before they go down
                for each (var stride:Number in [0.1, 0.5, 0.8, 1, 2])
                {
                    var hero:Agent = agentAt("hero", -2, 0, 0.001);
                    var queries:AgentQueries = new AgentQueries(EachCollider.make(name, land));
                    queries.terrain = terrain;
                    queries.update(new <Agent>[hero]);
                    queries.moveUntilTouch(hero, 0, 0, -9);
                    var walks:int = 0;
                    for (; walks < 90 && hero.x < 3.6; walks++)
                    {
                        queries.walk(hero, stride, 0, _options, _footing);
                        assertTrue([name, stride, walks, hero.x, hero.z].join(), _footing.stands);
                    }
                    assertTrue([name, stride, hero.x, hero.z].join(), walks < 90 && Math.abs(hero.z - 6 * RISE) < NEAR);
                    // in the air it is not pulled down
                    hero.moveTo(hero.x, 0, hero.z + 0.1);
                    queries.walk(hero, -0.1, 0, _options, _footing);
                    assertTrue(name, !_footing.stands && Math.abs(hero.z - 6 * RISE - 0.1) < NEAR);
                }
            }
        }

        // Both sides of a valley are steeper than 45 degrees, so the way down one side leads away from the way up the other.
        [Test]
        public function outOfAValleyAndAlongIt():void
        {
            var ways:Array = [[0.1, 0], [0, 0.1], [-0.3, 0.1]].slice(Effort.choose(0, 0, 2));
            _options.fall = 0;
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                for each (var degrees:Number in [30, 50, 80])
                {
                    var slope:Number = Math.tan(degrees * Math.PI / 180);
                    var terrain:Terrain = new Terrain(9, 9, 1, -4, -4);
                    fillHeights(terrain, function(column:int, row:int):Number
                        {
                            return slope * Math.abs(column - 4);
                        });
                    for each (var shape:String in WALKERS)
                    {
                        for each (var way:Array in ways)
                        {
                            var walker:Agent = walkerAt(shape, -0.5, 0, 9);
                            var queries:AgentQueries = queriesOf(name, new <Agent>[walker]);
                            queries.terrain = terrain;
                            queries.update(new <Agent>[walker]);
                            queries.moveUntilTouch(walker, 0, 0, -20);
                            _options.slopeDegrees = degrees + 5;
                            for (var i:int = 0; i < 5; i++)
                            {
                                queries.walk(walker, 0.1, 0, _options, _footing);
                            }
                            for (i = 1; i <= 8; i++)
                            {
                                queries.walk(walker, way[0], way[1], _options, _footing);
                                var isThere:Boolean = Math.abs(walker.x - i * way[0]) < NEAR && Math.abs(walker.y - i * way[1]) < NEAR;
                                _wrong.addIf(!isThere || !_footing.stands, [name, shape, degrees].join(),
                                        [way, i, walker.x, walker.y, walker.z, _footing.stands].join());
                                _wrong.addIf(queries.touchesAny(walker), "ends in a touch", [name, shape, degrees, way, i].join());
                            }
                        }
                    }
                }
            }
            _wrong.assertNone();
        }

        [Test]
        public function wallsFencesAndCeilings():void
        {
            for each (var name:String in NAMES)
            {
                for each (var shape:String in WALKERS)
                {
                    var message:String = name + ", " + shape;
                    var walker:Agent = walkerAt(shape, 0, 0, 0);
                    var fence:Agent = agentAt("cube", 1.2, 0, 0);
                    fence.size = 0.2;
                    var agents:Vector.<Agent> = new <Agent>[walker, fence];
                    addTiles(agents, -4, 4, flat);
                    for (var y:int = -4; y <= 4; y++)
                    {
                        agents.push(agentAt("cube", 3, y, 0));
                    }
                    var queries:AgentQueries = queriesOf(name, agents);
                    walkTo(queries, walker, 2, 0, 0.1, message + ", fence");
                    assertTrue(message + ": over the fence " + [walker.x, walker.z], walker.x > 1.9 && Math.abs(walker.z) < 0.01);
                    // along a wall
                    walker.moveTo(2, 0, 0);
                    queries.moved(walker);
                    queries.walk(walker, 1, 1, _options, _footing);
                    assertTrue(message + ": along the wall " + [walker.x, walker.y, walker.z], walker.x > 2 && walker.x < 2.26 && walker.y > 0.9 && Math.abs(walker.z) < 0.01);
                    assertTrue(message + ": " + _footing.part, _footing.stands && _footing.part > 0.7 && _footing.part < 0.75);
                    // a ceiling above the fence lets it not step up
                    agents.push(agentAt("cube", 1, 0, 0.6), agentAt("cube", 2, 0, 0.6));
                    queries.update(agents);
                    walker.moveTo(0.2, 0, 0);
                    queries.moved(walker);
                    walkTo(queries, walker, 2, 0, 0.1, "");
                    assertTrue(message + ": below a ceiling " + [walker.x, walker.y], walker.x < 1.2);
                }
            }
            _wrong.assertNone();
        }

        [Test]
        public function theFootingSaysWhatTheAgentWalksAgainst():void
        {
            for each (var name:String in NAMES)
            {
                for each (var shape:String in WALKERS)
                {
                    var message:String = name + ", " + shape;
                    var walker:Agent = walkerAt(shape, 0, 0, 0);
                    var fence:Agent = agentAt("cube", 1.2, 0, 0);
                    fence.size = 0.2;
                    var enemy:Agent = agentAt("cube", 3, 0, 0, "enemies");
                    var agents:Vector.<Agent> = new <Agent>[walker, fence, enemy];
                    addTiles(agents, -4, 4, flat);
                    var queries:AgentQueries = queriesOf(name, agents);
                    var steps:int = 0;
                    while (walker.x < 2.1 && steps++ < 50)
                    {
                        queries.walk(walker, 0.1, 0, _options, _footing);
                        // it may meet the fence in one walk and step over it in the next
                        _wrong.addIf(_footing.against != null && _footing.against !== fence, message, "on the way: " + _footing.against);
                        _wrong.addIf(_footing.against != null && _footing.part > 1 - 1e-9, message, "it has stepped over what it tells");
                    }
                    assertTrue(message, walker.x >= 2.1);
                    queries.walk(walker, 0, 0.1, _options, _footing);
                    assertNull(message + ": nothing is in its way", _footing.against);
                    queries.walk(walker, 0.5, -0.1, _options, _footing);
                    assertStrictlyEquals(message, enemy, _footing.against);
                    assertTrue(message, _footing.part < 0.6 && _footing.on.breed == "tiles");
                    assertTrue(message, String(_footing).indexOf("against " + enemy) > 0);
                    queries.walk(walker, 0, 0, _options, _footing);
                    assertNull(message + ": it goes nowhere", _footing.against);
                    // through the air
                    walker.moveTo(2, 0, 0.4);
                    queries.moved(walker);
                    queries.walk(walker, 1, 0, _options, _footing);
                    assertStrictlyEquals(message + ": in the air", enemy, _footing.against);
                    // the edge of a terrain's wall is too steep
                    queries.terrain = new Terrain(9, 9, 1, -4, -4);
                    queries.terrain.raiseWall(-2, 0, 3);
                    queries.update(new <Agent>[walker]);
                    walker.moveTo(-0.6, 0, 0.001);
                    queries.moved(walker);
                    queries.walk(walker, -1, 0, _options, _footing);
                    assertStrictlyEquals(message + ": too steep", queries.terrain.agent, _footing.against);
                }
            }
            _wrong.assertNone();
        }

        [Test]
        public function theFootingSaysWhatItMeetsOnTopOfAStep():void
        {
            for each (var name:String in NAMES)
            {
                for each (var shape:String in WALKERS)
                {
                    var message:String = name + ", " + shape;
                    var walker:Agent = walkerAt(shape, 0.7, 0, 0);
                    var kerb:Agent = agentAt("cube", 1.5, 0, -0.8);
                    var enemy:Agent = agentAt("cube", 1.8, 0, 0, "enemies");
                    var agents:Vector.<Agent> = new <Agent>[walker, kerb, enemy];
                    addTiles(agents, -4, 4, flat);
                    var queries:AgentQueries = queriesOf(name, agents);
                    queries.walk(walker, 0.5, 0, _options, _footing);
                    assertStrictlyEquals(message + ": " + [walker.x, walker.z], kerb, _footing.on);
                    assertStrictlyEquals(message, enemy, _footing.against);
                    // a step down and up again, without a wall
                    queries.walk(walker, -0.5, 0, _options, _footing);
                    agents.splice(2, 1);
                    queries.update(agents);
                    queries.walk(walker, 0.5, 0, _options, _footing);
                    assertStrictlyEquals(message + ": " + [walker.x, walker.z], kerb, _footing.on);
                    assertNull(message + ": no wall", _footing.against);
                }
            }
        }

        [Test]
        public function withoutFallsItGoesOverACliff():void
        {
            _options.fall = 0;
            for each (var name:String in NAMES)
            {
                var walker:Agent = walkerAt("cube", 0, 0, 0);
                var agents:Vector.<Agent> = new <Agent>[walker];
                addTiles(agents, -2, 1, flat);
                var queries:AgentQueries = queriesOf(name, agents);
                for (var i:int = 0; i < 30; i++)
                {
                    queries.walk(walker, 0.1, 0, _options, _footing);
                    assertEquals(name + ": " + walker.x, walker.x < 1.75 - NEAR, _footing.stands);
                    assertTrue(name + ": " + i + " " + [walker.x, walker.z, _footing.part], Math.abs(walker.x - 0.1 * (i + 1)) < NEAR && Math.abs(walker.z) < NEAR && _footing.part > 1 - NEAR);
                }
                assertNull(name, _footing.on);
                assertEquals(name, 1, _footing.normal.z);
                // it does not come back to ground that is below it, unless it stands
                walker.moveTo(0, 0, 0.2);
                queries.moved(walker);
                assertFalse(name, queries.walk(walker, 0, 0.1, _options, _footing).stands);
                assertTrue(name, walker.z == 0.2);
                queries.moveUntilTouch(walker, 0, 0, -1);
                assertTrue(name, queries.walk(walker, 0, 0, _options, _footing).stands && _footing.part == 1 && Math.abs(walker.z) < NEAR);
            }
        }

        [Test]
        public function itFallsOffACliffOfCubes():void
        {
            for each (var name:String in NAMES)
            {
                for each (var shape:String in WALKERS)
                {
                    var walker:Agent = walkerAt(shape, 0, 0, 0);
                    var agents:Vector.<Agent> = new <Agent>[walker];
                    addTiles(agents, -2, 1, flat);
                    addTiles(agents, 2, 6, deep);
                    var queries:AgentQueries = queriesOf(name, agents);
                    var falls:int = fallOff(queries, walker, 4, -2.2, name + ", " + shape);
                    assertTrue(name + ", " + shape + ": " + falls, falls >= 4 && falls <= 6);
                    assertEquals("tiles", _footing.on.breed);
                    // in the air, and all the way at once
                    walker.moveTo(4, 0, 700);
                    queries.moved(walker);
                    assertFalse(name, queries.walk(walker, 0, 0, _options, _footing).stands);
                    assertTrue(name + ": " + walker.z, Math.abs(walker.z - 699.5) < NEAR);
                    _options.fall = Infinity;
                    assertTrue(name, queries.walk(walker, 0.1, 0, _options, _footing).stands);
                    assertTrue(name + ": " + [walker.x, walker.z], Math.abs(walker.z + 2.2) < NEAR && Math.abs(walker.x - 4.1) < NEAR);
                    assertFalse(name, queries.touchesAny(walker));
                    // below everything it has nothing to land on
                    walker.moveTo(4, 0, -10);
                    queries.moved(walker);
                    assertFalse(name, queries.walk(walker, 0, 0, _options, _footing).stands);
                    assertEquals(name, -10, walker.z);
                    _options.fall = 0.5;
                }
            }
            _wrong.assertNone();
        }

        [Test]
        public function whatRisesBelowItLiftsIt():void
        {
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                for each (var shape:String in WALKERS)
                {
                    var walker:Agent = walkerAt(shape, 0, 0.1, 0.01);
                    var lift:Agent = agentAt("cube", 20, 0, -1);
                    var agents:Vector.<Agent> = new <Agent>[walker, lift];
                    var queries:AgentQueries = queriesOf(name, agents);
                    var terrain:Terrain = new Terrain(21, 21, 1, -10, -10);
                    queries.terrain = terrain;
                    queries.update(agents);
                    for each (var rise:Number in [0.01, 0.2, 0.7])
                    {
                        terrain.raiseMound(0, 0, 12, rise);
                        for (var i:int = 0; i < 1 + rise / 0.25; i++)
                        {
                            queries.walk(walker, 0.01, 0, _options, _footing);
                        }
                        var over:Number = walker.z - terrain.heightAt(walker.x, walker.y);
                        assertTrue(name + ", " + shape + ", " + rise + ": " + over, _footing.stands && Math.abs(over) < 0.1 && !queries.touchesAny(walker));
                    }
                    if (name == "bins")
                    {
                        continue;
                    }
                    walker.moveTo(20, 0, 0);
                    queries.moved(walker);
                    for (i = 0; i < 10; i++)
                    {
                        lift.z += 0.1;
                        queries.moved(lift);
                        queries.walk(walker, 0, 0, _options, _footing);
                        assertTrue(name + ", " + shape + ": " + [lift.z, walker.z], Math.abs(walker.z - lift.z - 1) < NEAR && _footing.on === lift);
                    }
                }
            }
        }

        [Test]
        public function hillsAreWalked():void
        {
            var frames:int = 0;
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                for (var world:int = 0; world < Effort.choose(4, 200); world++)
                {
                    var queries:AgentQueries = new AgentQueries(EachCollider.make(name, _greatLand));
                    var terrain:Terrain = new Terrain(24, 24, 1, -12, -12);
                    for (var i:int = 0; i < 12; i++)
                    {
                        terrain.raiseMound(_random.between(-10, 10), _random.between(-10, 10), _random.between(4, 9), _random.between(0.2, 0.8));
                    }
                    terrain.isBlocky = world % 4 >= 2;
                    _options.stepHeight = _options.snap = terrain.isBlocky ? 1 : 0.25;
                    queries.terrain = terrain;
                    var walker:Agent = walkerAt(world % 2 == 0 ? "sphere" : "cube", 0, 0, 20);
                    queries.update(new <Agent>[walker]);
                    queries.moveUntilTouch(walker, 0, 0, -40);
                    _options.slopeDegrees = 70;
                    var turn:Number = _random.between(0, 7);
                    for (i = 0; i < 80; i++)
                    {
                        frames++;
                        var x:Number = walker.x;
                        var y:Number = walker.y;
                        queries.walk(walker, 0.12 * Math.cos(turn), 0.12 * Math.sin(turn), _options, _footing);
                        var message:String = i + " at " + [x, y, walker.x, walker.y, walker.z, terrain.heightAt(walker.x, walker.y)] + " " + _footing.part;
                        _wrong.addIf(!_footing.stands || _footing.on != terrain.agent, name + ": does not stand", message);
                        _wrong.addIf(!(_footing.part > 1 - NEAR), name + ": stuck", message);
                        _wrong.addIf(terrain.heightAt(walker.x, walker.y) > walker.z + 0.2, name + ": in the ground", message);
                        _wrong.addIf(queries.touchesAny(walker), name + ": ends in a touch", message);
                        if (Math.abs(walker.x) > 10 || Math.abs(walker.y) > 10)
                        {
                            walker.moveTo(-0.9 * walker.x, -0.9 * walker.y, 20);
                            queries.moved(walker);
                            queries.moveUntilTouch(walker, 0, 0, -40);
                        }
                    }
                }
            }
            _wrong.assertNone();
            assertTrue(String(frames), frames > 1000);
        }

        [Test]
        public function whatIsRefusedChangesNothing():void
        {
            assertThrows(RangeError, /slopeDegrees.*-5/, assign, _options, "slopeDegrees", -5);
            assertEquals("0.25 45 0.25 0.5", [_options.stepHeight, _options.slopeDegrees, _options.snap, _options.fall].join(" "));
            var queries:AgentQueries = queriesOf("triangles", new <Agent>[agentAt("cube", 0, 0, -1)]);
            var walker:Agent = walkerAt("cube", 0, 0, 0);
            assertThrows(RangeError, /NaN/, queries.walk, walker, NaN, 0);
            assertThrows(ArgumentError, /null/, queries.walk, null, 1, 0);
            assertThrows(ArgumentError, /unicorn/, queries.walk, new Agent("unicorn"), 1, 0);
            assertEquals(0, walker.x);
            assertTrue("in no list, and with no options", queries.walk(walker, 0.1, 0).stands && walker.x > 0.09);
            var loader:ModelLoader = new ModelLoader(_greatLand);
            loader.load("late", "late.obj");
            var late:Agent = new Agent("late");
            assertFalse(queries.walk(late, 1, 2, _options, _footing).stands);
            assertTrue("a loading agent goes anywhere", late.x == 1 && late.y == 2 && _footing.part == 1 && _footing.on == null);
            loader.cancel("late");
            _greatLand.removeModel("cube");
            var x:Number = walker.x;
            assertThrows(ArgumentError, /cube/, queries.walk, walker, 0.1, 0);
            assertThrows(ArgumentError, /cube/, queries.slide, walker, 0.1, 0, 0);
            assertThrows(ArgumentError, /cube/, queries.moveUntilTouch, walker, 0.1, 0, 0);
            assertEquals(x, walker.x);
        }

        [Test]
        public function filtersLetThroughFloorsToo():void
        {
            var walker:Agent = walkerAt("cube", 0, 0, 0);
            var agents:Vector.<Agent> = new <Agent>[walker, agentAt("cube", 1, 0, 0, "ghosts")];
            addTiles(agents, -3, 3, flat);
            var queries:AgentQueries = queriesOf("triangles", agents);
            _options.filter = new AgentFilter();
            _options.filter.exceptBreeds = new <String>["ghosts"];
            _options.filter.accepts = function(agent:Agent):Boolean
            {
                // a walk of its own, of another agent, with other options
                queries.walk(walkerAt("sphere", 0, 0, 30), 5, 5);
                return true;
            };
            assertTrue(queries.walk(walker, 1.5, 0, _options, _footing).stands && Math.abs(walker.x - 1.5) < NEAR);
            _options.filter.exceptBreeds = new <String>["ghosts", "tiles"];
            assertFalse(queries.walk(walker, 0.5, 0, _options, _footing).stands);
        }

        private function walkTo(queries:AgentQueries, walker:Agent, x:Number, y:Number, step:Number, name:String):int
        {
            var frames:int = 0;
            for (; frames < 150; frames++)
            {
                var toX:Number = x - walker.x;
                var toY:Number = y - walker.y;
                var far:Number = Math.sqrt(toX * toX + toY * toY);
                if (far < 0.01)
                {
                    break;
                }
                var share:Number = Math.min(1, step / far);
                queries.walk(walker, share * toX, share * toY, _options, _footing);
                _wrong.addIf(queries.touchesAny(walker), name + ": ends in a touch", frames + " at " + [walker.x, walker.y, walker.z]);
                _wrong.addIf(name != "" && !_footing.stands, name + ": does not stand", frames + " at " + [walker.x, walker.y, walker.z, _footing.part]);
            }
            return frames;
        }

        // Walks along x and falls. Returns the number of walks after which it did not stand.
        private function fallOff(queries:AgentQueries, walker:Agent, x:Number, bottom:Number, message:String):int
        {
            var falls:int = 0;
            for (var i:int = 0; i < 90 && (walker.x < x || !_footing.stands); i++)
            {
                var z:Number = walker.z;
                queries.walk(walker, Math.min(0.1, x - walker.x), 0, _options, _footing);
                falls += _footing.stands ? 0 : 1;
                _wrong.addIf(walker.z < z - 0.51 - 0.25 || walker.z > z + NEAR || walker.z < bottom - NEAR,
                        message + ": falls too far", i + ": " + [walker.x, walker.z, z]);
                _wrong.addIf(queries.touchesAny(walker), message + ": ends in a touch", i + ": " + [walker.x, walker.z, _footing.stands]);
            }
            _wrong.addIf(!_footing.stands || Math.abs(walker.z - bottom) > 1e-3 || !(walker.x > x - NEAR),
                    message + ": does not land", [walker.x, walker.z, _footing.stands].join());
            return falls;
        }

        private function queriesOf(name:String, agents:Vector.<Agent>):AgentQueries
        {
            for each (var agent:Agent in agents)
            {
                agent.hierarchical = true;
            }
            var queries:AgentQueries = new AgentQueries(EachCollider.make(name, _greatLand));
            queries.update(agents);
            return queries;
        }

        private static function flat(x:int):Number
        {
            return 0;
        }

        private static function deep(x:int):Number
        {
            return -2.2;
        }

        // Cubes with their tops at some heights.
        private static function addTiles(agents:Vector.<Agent>, from:int, to:int, heightOf:Function):void
        {
            for (var x:int = from; x <= to; x++)
            {
                for (var y:int = -5; y <= 5; y++)
                {
                    agents.push(agentAt("cube", x, y, heightOf(x) - 1, "tiles"));
                }
            }
        }

        private static function walkerAt(shape:String, x:Number, y:Number, z:Number):Agent
        {
            var agent:Agent = agentAt(shape, x, y, z, "walkers");
            agent.size = 0.5;
            return agent;
        }
    }
}
