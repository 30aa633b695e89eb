// Where the server is looked for.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { type Machine, findServer } from '../../src/server';

function machine(programs: string[], env: Machine['env'] = {}, platform: NodeJS.Platform = 'linux'): Machine {
  return {
    platform,
    env,
    home: platform === 'win32' ? 'C:\\Home' : '/user',
    isProgram: (file) => programs.includes(file),
  };
}

const wishes = { setting: null, extension: '/extension', workspace: '/programs' };

test('the bundled server comes before PATH', () => {
  const both = machine(['/extension/server/cnc872c', '/bin/cnc872c'], { PATH: '/bin' });
  assert.deepEqual(findServer(wishes, both), { kind: 'found', program: '/extension/server/cnc872c' });
  const path = machine(['/opt/bin/cnc872c'], { PATH: '/bin:/opt/bin' });
  assert.deepEqual(findServer(wishes, path), { kind: 'found', program: '/opt/bin/cnc872c' });
});

test('the setting wins, and is not passed over when it is wrong', () => {
  const all = machine(['/extension/server/cnc872c', '/own/cnc872c', '/bin/other'], { PATH: '/bin' });
  const find = (setting: string) => findServer({ ...wishes, setting }, all);
  assert.deepEqual(find('/own/cnc872c'), { kind: 'found', program: '/own/cnc872c' });
  assert.deepEqual(find(' other '), { kind: 'found', program: '/bin/other' });
  assert.deepEqual(find('/nowhere/cnc872c'), { kind: 'wrong-setting', program: '/nowhere/cnc872c' });
  assert.deepEqual(find('unknown'), { kind: 'wrong-setting', program: 'unknown' });
  assert.equal(find('   ').kind, 'found');
});

test('paths of the setting may be relative, or begin with the home folder or that of the workspace', () => {
  const all = machine(['/programs/tools/cnc872c', '/user/bin/cnc872c']);
  for (const setting of ['tools/cnc872c', './tools/cnc872c', '${workspaceFolder}/tools/cnc872c']) {
    assert.deepEqual(findServer({ ...wishes, setting }, all), { kind: 'found', program: '/programs/tools/cnc872c' });
  }
  const home = { ...wishes, setting: '~/bin/cnc872c', workspace: undefined };
  assert.deepEqual(findServer(home, all), { kind: 'found', program: '/user/bin/cnc872c' });
});

test('nothing is run from relative folders on PATH', () => {
  const all = machine(['bin/cnc872c', './cnc872c', 'cnc872c', '/programs/cnc872c'], { PATH: 'bin:.::' });
  assert.deepEqual(findServer(wishes, all), { kind: 'missing' });
});

test('no PATH at all', () => {
  assert.deepEqual(findServer(wishes, machine([])), { kind: 'missing' });
});

test('on Windows', () => {
  const all = machine(['C:\\Tools\\cnc872c.exe'], { Path: '"C:\\Tools";D:\\Other' }, 'win32');
  const windows = { setting: null, extension: 'C:\\Extension', workspace: 'C:\\Programs' };
  assert.deepEqual(findServer(windows, all), { kind: 'found', program: 'C:\\Tools\\cnc872c.exe' });
  for (const setting of ['C:\\Tools\\cnc872c.exe', 'C:/Tools/cnc872c', '..\\Tools\\cnc872c', 'cnc872c']) {
    assert.equal(findServer({ ...windows, setting }, all).kind, 'found', setting);
  }
});
